// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/dds.h>

#include <memory>

#include "core/wire/delivery.h"
#include "core/wire/endpoints.h"

namespace galilean::wire {

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, DeleteQos>;

[[nodiscard]] Qos make_qos(Delivery delivery);

/// Returns the QoS of a reader that asks for no more than that, in whatever partition its writers
/// are, and that keeps so many messages. What it asks of deadlines and of history is ignored.
[[nodiscard]] Qos make_reader_qos(const EndpointQos& asked, int depth);

/// Returns `result`. Errors: throws std::runtime_error "what: Cyclone's reason" if it is negative.
std::int32_t checked(std::int32_t result, const std::string& what);

}  // namespace galilean::wire
