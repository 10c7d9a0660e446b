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
const wire::Schema* own_schema(const mcap::Schema& schema) {
  const auto* known = wire::find_schema_by_ros_type(schema.name);
  const auto* own = known ? wire::find_own_type(known->dds_type) : nullptr;
  if (!own) return nullptr;
  const auto definition = wire::message_definition(own->description);
  return definition && definition.value() == schema.data ? known : nullptr;
}

}  // namespace

Result<mcap::Schema> in_language(const mcap::Schema& schema, const std::string& encoding) {
  if (schema.encoding == encoding) return schema;
  mcap::Schema other{schema.id, schema.name, encoding, {}};
  const auto* own = encoding == kMessageLanguage ? nullptr : own_schema(schema);
  if (own) {
    other.data = std::string(own->idl);
    return other;
  }
  const auto type = monitor::type_of_schema(schema);
  if (!type) return type.error();
  if (encoding == kMessageLanguage) {
    auto definition = wire::message_definition(type.value());
    if (!definition) return definition.error();
    other.data = std::move(definition).value();
    return other;
  }
  other.encoding = "omgidl";
  other.data = wire::type_text(type.value());
  return other;
}

}  // namespace galilean::logs
