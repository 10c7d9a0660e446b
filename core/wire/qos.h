// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/dds.h>

#include <memory>

#include "core/wire/delivery.h"

namespace galilean::wire {

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, DeleteQos>;

[[nodiscard]] Qos make_qos(Delivery delivery);

/// Returns `result`. Errors: throws std::runtime_error "what: Cyclone's reason" if it is negative.
std::int32_t checked(std::int32_t result, const std::string& what);

}  // namespace galilean::wire
