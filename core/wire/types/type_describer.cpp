// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/type_describer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/wire/type_hash.h"

namespace galilean::wire {
namespace {

constexpr int kDeepestType = 32;

struct Primitive {
  std::uint8_t kind;
  TypeKind described;
  int bytes;
};
/// XTypes 1.3 numbers the two of eight bits as here. Cyclone 0.10 does not name them.
constexpr std::uint8_t kXtypesInt8 = 0x0C, kXtypesUint8 = 0x0D;
constexpr std::array kPrimitives{
    Primitive{DDS_XTypes_TK_BOOLEAN, TypeKind::kBoolean, 1},
    Primitive{DDS_XTypes_TK_BYTE, TypeKind::kByte, 1},
    Primitive{kXtypesUint8, TypeKind::kByte, 1},
    Primitive{kXtypesInt8, TypeKind::kInt8, 1},
    Primitive{DDS_XTypes_TK_CHAR8, TypeKind::kChar, 1},
    Primitive{DDS_XTypes_TK_INT16, TypeKind::kInt16, 2},
    Primitive{DDS_XTypes_TK_UINT16, TypeKind::kUint16, 2},
    Primitive{DDS_XTypes_TK_INT32, TypeKind::kInt32, 4},
    Primitive{DDS_XTypes_TK_UINT32, TypeKind::kUint32, 4},
    Primitive{DDS_XTypes_TK_INT64, TypeKind::kInt64, 8},
    Primitive{DDS_XTypes_TK_UINT64, TypeKind::kUint64, 8},
    Primitive{DDS_XTypes_TK_FLOAT32, TypeKind::kFloat, 4},
    Primitive{DDS_XTypes_TK_FLOAT64, TypeKind::kDouble, 8},
};

/// Throws because of a type that is not decoded.
[[noreturn]] void refuse(std::uint8_t kind) {
  switch (kind) {
    case DDS_XTypes_TK_FLOAT128:
      throw Indescribable("holds a floating-point number of 128 bits");
    case DDS_XTypes_TK_CHAR16:
      throw Indescribable("holds a wide character");
    case DDS_XTypes_TK_STRING16:
    case DDS_XTypes_TI_STRING16_SMALL:
    case DDS_XTypes_TI_STRING16_LARGE:
      throw Indescribable("holds a text of wide characters");
    case DDS_XTypes_TK_MAP:
    case DDS_XTypes_TI_PLAIN_MAP_SMALL:
    case DDS_XTypes_TI_PLAIN_MAP_LARGE:
      throw Indescribable("holds a map");
    case DDS_XTypes_TK_BITSET:
      throw Indescribable("holds a bitset");
    case DDS_XTypes_TI_STRONGLY_CONNECTED_COMPONENT:
      throw Indescribable("holds itself");
    case DDS_XTypes_EK_MINIMAL:
      throw Indescribable("is published without the names of its fields");
    default:
      throw Indescribable("holds a value of the unknown kind " + std::to_string(kind));
  }
}

Type primitive_type(std::uint8_t kind, bool in_ros_type) {
  const auto* found = std::ranges::find(kPrimitives, kind, &Primitive::kind);
  if (found == kPrimitives.end()) refuse(kind);
  TypeDescription type{.kind = found->described, .bytes = found->bytes};
  if (type.kind == TypeKind::kChar && in_ros_type) type.kind = TypeKind::kInt8;
  return std::make_shared<TypeDescription>(std::move(type));
}

Type text_type(std::uint32_t bound) {
  TypeDescription type{.kind = TypeKind::kString};
  if (bound) type.bounds = {bound};
  return std::make_shared<TypeDescription>(std::move(type));
}

template <class Sequence>
std::vector<std::uint32_t> sizes(const Sequence& bounds) {
  return {bounds._buffer, bounds._buffer + bounds._length};
}

}  // namespace

void TypeDescriber::reach(int depth) {
  if (depth > kDeepestType)
    throw Indescribable("nests deeper than " + std::to_string(kDeepestType) + " levels");
  deepest_ = std::max(deepest_, depth);
}

Type TypeDescriber::describe(const DDS_XTypes_TypeIdentifier& id, Place place) {
  reach(place.depth);
  switch (id._d) {
    case DDS_XTypes_TI_STRING8_SMALL:
      return text_type(id._u.string_sdefn.bound);
    case DDS_XTypes_TI_STRING8_LARGE:
      return text_type(id._u.string_ldefn.bound);
    case DDS_XTypes_TI_PLAIN_SEQUENCE_SMALL:
      return sequence(id._u.seq_sdefn.element_identifier, id._u.seq_sdefn.bound, place);
    case DDS_XTypes_TI_PLAIN_SEQUENCE_LARGE:
      return sequence(id._u.seq_ldefn.element_identifier, id._u.seq_ldefn.bound, place);
    case DDS_XTypes_TI_PLAIN_ARRAY_SMALL:
      return array(id._u.array_sdefn.element_identifier, sizes(id._u.array_sdefn.array_bound_seq),
                   place);
    case DDS_XTypes_TI_PLAIN_ARRAY_LARGE:
      return array(id._u.array_ldefn.element_identifier, sizes(id._u.array_ldefn.array_bound_seq),
                   place);
    case DDS_XTypes_EK_COMPLETE:
      return named(id, place);
    default:
      return primitive_type(id._d, place.in_ros_type);
  }
}

Type TypeDescriber::sequence(const DDS_XTypes_TypeIdentifier* element, std::uint32_t bound,
                             Place place) {
  if (!element) throw Indescribable("has a sequence of nothing");
  TypeDescription type{.kind = TypeKind::kSequence};
  type.element = describe(*element, place.inside());
  if (bound) type.bounds = {bound};
  return std::make_shared<TypeDescription>(std::move(type));
}

Type TypeDescriber::array(const DDS_XTypes_TypeIdentifier* element,
                          std::vector<std::uint32_t> bounds, Place place) {
  if (!element || bounds.empty()) throw Indescribable("has an array of nothing");
  TypeDescription type{.kind = TypeKind::kArray, .bounds = std::move(bounds)};
  type.element = describe(*element, place.inside());
  // Cyclone encodes an array of arrays as one array of more dimensions.
  if (type.element->kind == TypeKind::kArray) {
    const Type inner = type.element;
    type.bounds.insert(type.bounds.end(), inner->bounds.begin(), inner->bounds.end());
    type.element = inner->element;
  }
  return std::make_shared<TypeDescription>(std::move(type));
}

Type TypeDescriber::named(const DDS_XTypes_TypeIdentifier& id, Place place) {
  const auto hash = type_hash(id);
  const auto key = std::pair(hash, place.in_ros_type);
  if (const auto known = known_.find(key); known != known_.end()) {
    // It may have been described at a place that is less deep than this one.
    reach(place.depth + known->second.levels);
    return known->second.type;
  }
  const auto found = find_(hash);
  if (!found) throw Indescribable(found.error().message);
  if (found.value()->_d != DDS_XTypes_EK_COMPLETE) refuse(DDS_XTypes_EK_MINIMAL);
  const int around = std::exchange(deepest_, place.depth);
  Type type = defined(found.value()->_u.complete, place);
  known_[key] = {type, deepest_ - place.depth};
  deepest_ = std::max(deepest_, around);
  return type;
}

}  // namespace galilean::wire
