// SPDX-License-Identifier: BSD-3-Clause
// Describes what XTypes defines by a TypeObject: structs, unions, enums, bitmasks and aliases.
#include <cstring>
#include <span>

#include "core/wire/types/type_describer.h"

namespace galilean::wire {
namespace {

template <class Sequence>
auto items(const Sequence& sequence) {
  return std::span(sequence._buffer, sequence._length);
}

template <std::size_t kSize>
std::string text_of(const char (&name)[kSize]) {
  return {name, strnlen(name, kSize)};
}

/// Returns whether ROS 2 made this name, such as "std_msgs::msg::dds_::String_".
bool is_ros_name(const std::string& name) {
  for (const char* folder : {"::msg::", "::srv::", "::action::"})
    if (name.find(folder) != name.npos) return true;
  return false;
}

Extensibility extensibility_of(std::uint16_t flags) {
  if (flags & DDS_XTypes_IS_MUTABLE) return Extensibility::kMutable;
  return flags & DDS_XTypes_IS_APPENDABLE ? Extensibility::kAppendable : Extensibility::kFinal;
}

/// Returns the size [bytes] of the smallest integer that holds so many bits.
int bytes_of(int bits) {
  int bytes = 1;
  while (bytes < 8 && bytes * 8 < bits) bytes *= 2;
  return bytes;
}

Type enum_type(const DDS_XTypes_CompleteEnumeratedType& object) {
  TypeDescription type{.kind = TypeKind::kEnum,
                       .bytes = bytes_of(object.header.common.bit_bound),
                       .name = text_of(object.header.detail.type_name)};
  for (const auto& literal : items(object.literal_seq))
    type.constants.push_back({text_of(literal.detail.name), literal.common.value});
  return std::make_shared<TypeDescription>(std::move(type));
}

Type bitmask_type(const DDS_XTypes_CompleteBitmaskType& object) {
  TypeDescription type{.kind = TypeKind::kBitmask,
                       .bytes = bytes_of(object.header.common.bit_bound),
                       .name = text_of(object.header.detail.type_name)};
  for (const auto& flag : items(object.flag_seq))
    type.constants.push_back({text_of(flag.detail.name), flag.common.position});
  return std::make_shared<TypeDescription>(std::move(type));
}

}  // namespace

Type TypeDescriber::defined(const DDS_XTypes_CompleteTypeObject& object, Place place) {
  switch (object._d) {
    case DDS_XTypes_TK_ALIAS:
      return describe(object._u.alias_type.body.common.related_type, place.inside());
    case DDS_XTypes_TK_ENUM:
      return enum_type(object._u.enumerated_type);
    case DDS_XTypes_TK_BITMASK:
      return bitmask_type(object._u.bitmask_type);
    case DDS_XTypes_TK_SEQUENCE:
      return sequence(&object._u.sequence_type.element.common.type,
                      object._u.sequence_type.header.common.bound, place);
    case DDS_XTypes_TK_ARRAY: {
      const auto bounds = items(object._u.array_type.header.common.bound_seq);
      return array(&object._u.array_type.element.common.type, {bounds.begin(), bounds.end()},
                   place);
    }
    case DDS_XTypes_TK_STRUCTURE:
      return structure(object._u.struct_type, place);
    case DDS_XTypes_TK_UNION:
      return choice(object._u.union_type, place);
    case DDS_XTypes_TK_MAP:
      throw Indescribable("holds a map");
    case DDS_XTypes_TK_BITSET:
      throw Indescribable("holds a bitset");
    default:
      throw Indescribable("holds a type of the unknown kind " + std::to_string(object._d));
  }
}

Type TypeDescriber::structure(const DDS_XTypes_CompleteStructType& object, Place place) {
  TypeDescription type{.kind = TypeKind::kStruct,
                       .name = text_of(object.header.detail.type_name),
                       .extensibility = extensibility_of(object.struct_flags)};
  const Place inside{place.depth + 1, is_ros_name(type.name)};
  if (object.header.base_type._d != DDS_XTypes_TK_NONE) {
    const Type base = describe(object.header.base_type, inside);
    if (base->kind != TypeKind::kStruct) throw Indescribable("has a base that is no struct");
    type.members = base->members;
  }
  for (const auto& member : items(object.member_seq)) {
    const auto flags = member.common.member_flags;
    type.members.push_back({.name = text_of(member.detail.name),
                            .id = member.common.member_id,
                            .type = describe(member.common.member_type_id, inside),
                            .optional = (flags & DDS_XTypes_IS_OPTIONAL) != 0,
                            .key = (flags & DDS_XTypes_IS_KEY) != 0});
  }
  return std::make_shared<TypeDescription>(std::move(type));
}

Type TypeDescriber::choice(const DDS_XTypes_CompleteUnionType& object, Place place) {
  TypeDescription type{.kind = TypeKind::kUnion,
                       .name = text_of(object.header.detail.type_name),
                       .extensibility = extensibility_of(object.union_flags)};
  if (type.extensibility == Extensibility::kMutable)
    throw Indescribable("holds a union that is mutable");
  const Place inside{place.depth + 1, is_ros_name(type.name)};
  type.element = describe(object.discriminator.common.type_id, inside);
  const TypeKind selector = type.element->kind;
  if (selector > TypeKind::kBitmask || selector == TypeKind::kFloat ||
      selector == TypeKind::kDouble)
    throw Indescribable("holds a union that no whole number selects");
  for (const auto& member : items(object.member_seq)) {
    const auto labels = items(member.common.label_seq);
    type.members.push_back(
        {.name = text_of(member.detail.name),
         .id = member.common.member_id,
         .type = describe(member.common.type_id, inside),
         .labels = {labels.begin(), labels.end()},
         .otherwise = (member.common.member_flags & DDS_XTypes_IS_DEFAULT) != 0});
  }
  return std::make_shared<TypeDescription>(std::move(type));
}

}  // namespace galilean::wire
