// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/known_type.h"

#include <algorithm>
#include <sstream>

#include "core/wire/types/message_definition.h"
#include "core/wire/types/own_types.h"

namespace galilean::monitor {
namespace {

/// Returns the words of an IDL text without its comments, each with one blank behind it.
std::string words_of(std::string_view idl) {
  std::string words;
  while (!idl.empty()) {
    const auto end = std::min(idl.find('\n'), idl.size());
    const auto code = idl.substr(0, end);
    std::istringstream line(std::string(code.substr(0, code.find("//"))));
    for (std::string word; line >> word;) words += word + ' ';
    idl.remove_prefix(std::min(end + 1, idl.size()));
  }
  return words;
}

/// Comments and layout are no part of a type: messages of another release may differ in them alone.
bool defines_alike(const mcap::Schema& schema, const wire::Schema& known) {
  if (schema.encoding != "ros2msg")
    return known.idl == schema.data || words_of(known.idl) == words_of(schema.data);
  const auto* own = wire::find_own_type(known.dds_type);
  if (!own) return false;
  const auto definition = wire::message_definition(own->description);
  return definition && definition.value() == schema.data;
}

}  // namespace

const wire::Schema* known_type(const mcap::Schema& schema) {
  const auto* known = wire::find_schema_by_ros_type(schema.name);
  return known && defines_alike(schema, *known) ? known : nullptr;
}

}  // namespace galilean::monitor
