// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/dds.h>

#include <string>

#include "core/hexadecimal.h"

namespace galilean::wire {

using galilean::hexadecimal;

[[nodiscard]] inline std::string hexadecimal(const dds_guid_t& guid) {
  return galilean::hexadecimal(guid.v);
}

/// Returns the name that an entity announced, or an empty text if it announced none.
[[nodiscard]] inline std::string announced_name(const dds_qos_t* qos) {
  char* name = nullptr;
  if (!dds_qget_entity_name(qos, &name) || !name) return {};
  std::string copy = name;
  dds_free(name);
  return copy;
}

}  // namespace galilean::wire
