// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/schemas.h"

namespace galilean::wire {

const Schema* find_schema_by_ros_type(std::string_view ros_type) noexcept {
  for (const auto& schema : schemas())
    if (schema.ros_type == ros_type) return &schema;
  return nullptr;
}

const Schema* find_schema_by_dds_type(std::string_view dds_type) noexcept {
  for (const auto& schema : schemas())
    if (schema.dds_type == dds_type) return &schema;
  return nullptr;
}

}  // namespace galilean::wire
