// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace galilean::wire {

struct TypeDescription;
/// A type, which all that are made of it share. No type holds itself, since its name on the wire is
/// a hash of all that it holds.
using Type = std::shared_ptr<const TypeDescription>;

/// What a value is. Those up to kDouble are primitive: they are their own size in any encoding.
enum class TypeKind {
  kBoolean,
  kByte,  ///< unsigned, 8 bits
  kInt8,
  kChar,  ///< one byte that is a letter
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat,
  kDouble,
  kEnum,
  kBitmask,
  kString,
  kSequence,
  kArray,
  kStruct,
  kUnion
};

/// How a struct or union may change between releases, which decides how XCDR encodes it.
enum class Extensibility { kFinal, kAppendable, kMutable };

/// A field of a struct, or a choice of a union.
struct TypeMember {
  std::string name;
  std::uint32_t id = 0;
  Type type;
  bool optional = false;
  bool key = false;
  std::vector<std::int32_t> labels;  ///< of a union: the discriminator's values that select it
  bool otherwise = false;            ///< of a union: values that no label names select it
};

/// A value of an enum, or a flag of a bitmask with its position.
struct TypeConstant {
  std::string name;
  std::int32_t value = 0;
};

struct TypeDescription {
  TypeKind kind = TypeKind::kBoolean;
  int bytes = 0;     ///< size of a primitive value, an enum or a bitmask; 0 for others
  std::string name;  ///< of an enum, bitmask, struct or union, such as "foreign::Point"
  Extensibility extensibility = Extensibility::kFinal;
  Type element;  ///< of a sequence or array; of a union its discriminator
  /// The sizes of an array, the outermost first. The longest length of a string or sequence, or
  /// nothing if it has no bound.
  std::vector<std::uint32_t> bounds;
  std::vector<TypeMember> members;      ///< of a struct, those of its base first; of a union
  std::vector<TypeConstant> constants;  ///< of an enum or bitmask
};

[[nodiscard]] constexpr bool is_primitive(TypeKind kind) noexcept {
  return kind <= TypeKind::kDouble;
}

}  // namespace galilean::wire
