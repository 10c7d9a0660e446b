// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/writing/schema_language.h"

#include <utility>

#include "core/wire/schemas.h"
#include "core/wire/types/message_definition.h"
#include "core/wire/types/own_types.h"
#include "core/wire/types/type_text.h"
#include "monitor/schemas/message_trees.h"

namespace galilean::logs {
namespace {

constexpr const char* kMessageLanguage = "ros2msg";

/// Returns this release's own schema of the type, or nullptr if it defines none that is the same.
const wire::Schema* own_schema(const std::string& ros_type, const std::string& definition) {
  const auto* known = wire::find_schema_by_ros_type(ros_type);
  const auto* own = known ? wire::find_own_type(known->dds_type) : nullptr;
  if (!own) return nullptr;
  const auto ours = wire::message_definition(own->description);
  return ours && ours.value() == definition ? known : nullptr;
}

}  // namespace

Result<mcap::Schema> in_language(const mcap::Schema& schema, const std::string& encoding) {
  if (schema.encoding == encoding) return schema;
  const auto type = monitor::type_of_schema(schema);
  if (!type) return type.error();
  auto definition = wire::message_definition(type.value());
  mcap::Schema other{schema.id, schema.name, encoding, {}};
  if (encoding == kMessageLanguage) {
    if (!definition) return definition.error();
    other.data = std::move(definition).value();
    return other;
  }
  const auto* own = definition ? own_schema(schema.name, definition.value()) : nullptr;
  if (own) {
    other.data = std::string(own->idl);
    return other;
  }
  other.encoding = "omgidl";
  other.data = wire::type_text(type.value());
  return other;
}

}  // namespace galilean::logs
