// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/message_definition.h"

#include <array>
#include <optional>
#include <set>
#include <vector>

#include "core/visible_text.h"

namespace galilean::wire {
namespace {

/// In the order of TypeKind. What is unsigned and of 8 bits is "uint8" and "byte" alike.
constexpr std::array kPrimitiveNames{"bool",  "uint8",  "int8",  "char",   "int16",   "uint16",
                                     "int32", "uint32", "int64", "uint64", "float32", "float64"};
constexpr std::string_view kRosRoom = "::msg::dds_::", kIdlRoom = "::msg::";
const std::string kSeparator = std::string(80, '=') + "\nMSG: ";

/// Returns "geometry_msgs/Point" for "geometry_msgs::msg::dds_::Point_", as it is called on DDS,
/// and for "geometry_msgs::msg::Point", as IDL calls it; or an empty text for a name that is no
/// message's.
std::string message_name(const std::string& name) {
  const auto room = name.find(kRosRoom);
  if (room != name.npos && name.ends_with('_')) {
    const auto start = room + kRosRoom.size();
    return visible(name.substr(0, room) + "/" + name.substr(start, name.size() - start - 1));
  }
  const auto plain = name.find(kIdlRoom);
  if (plain == name.npos || name.find("::", plain + kIdlRoom.size()) != name.npos) return "";
  return visible(name.substr(0, plain) + "/" + name.substr(plain + kIdlRoom.size()));
}

class DefinitionWriter {
 public:
  Result<std::string> write(const Type& type) {
    if (auto problem = add(*type)) return Error{*problem};
    while (!waiting_.empty()) {
      const TypeDescription& next = *waiting_.back();
      waiting_.pop_back();
      text_ += kSeparator + message_name(next.name) + "\n";
      if (auto problem = add(next)) return Error{*problem};
    }
    return text_;
  }

 private:
  using Problem = std::optional<std::string>;

  Problem add(const TypeDescription& type) {
    if (type.kind != TypeKind::kStruct) return "is no struct";
    if (type.extensibility == Extensibility::kMutable) return "is a mutable struct";
    for (const auto& member : type.members) {
      if (member.optional) return "has the optional field " + visible(member.name);
      const auto field = use_of(*member.type);
      if (!field)
        return "has the field " + visible(member.name) + ", which " + field.error().message;
      text_ += field.value() + " " + visible(member.name) + "\n";
    }
    return std::nullopt;
  }

  /// Returns how a field names its type. Errors: a clause.
  Result<std::string> use_of(const TypeDescription& type) {
    if (type.kind == TypeKind::kSequence)
      return with_sizes(type, type.bounds.empty() ? "[]" : "[<=" + bound_of(type) + "]");
    if (type.kind == TypeKind::kArray) {
      if (type.bounds.size() != 1) return Error{"is an array of several dimensions"};
      return with_sizes(type, "[" + bound_of(type) + "]");
    }
    return single(type);
  }

  Result<std::string> with_sizes(const TypeDescription& type, const std::string& sizes) {
    auto element = single(*type.element);
    if (!element) return element;
    return element.value() + sizes;
  }

  Result<std::string> single(const TypeDescription& type) {
    if (is_primitive(type.kind))
      return std::string(kPrimitiveNames.at(static_cast<std::size_t>(type.kind)));
    if (type.kind == TypeKind::kString)
      return type.bounds.empty() ? "string" : "string<=" + bound_of(type);
    const std::string name = message_name(type.name);
    if (type.kind != TypeKind::kStruct || name.empty())
      return Error{type.kind == TypeKind::kSequence || type.kind == TypeKind::kArray
                       ? std::string("is a list of lists")
                       : "is of the type " + visible(type.name) + ", which is no message"};
    if (named_.insert(type.name).second) waiting_.push_back(&type);
    return name;
  }

  static std::string bound_of(const TypeDescription& type) {
    return std::to_string(type.bounds.front());
  }

  std::string text_;
  std::set<std::string> named_;
  std::vector<const TypeDescription*> waiting_;  ///< named, and not written yet
};

}  // namespace

Result<std::string> message_definition(const Type& type) {
  return DefinitionWriter().write(type);
}

}  // namespace galilean::wire
