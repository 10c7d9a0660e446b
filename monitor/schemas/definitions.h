// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/wire/types/type_description.h"

namespace galilean::monitor {

/// How a field's type is written in a schema.
struct WrittenType {
  enum class Kind { kPrimitive, kString, kSequence, kNamed };
  Kind kind = Kind::kNamed;
  wire::TypeKind primitive = wire::TypeKind::kBoolean;
  std::string name;                      ///< of a named one: "Point" or "geometry_msgs::msg::Point"
  std::optional<std::uint32_t> bound;    ///< the longest length of a string or sequence
  std::shared_ptr<WrittenType> element;  ///< of a sequence
};

struct WrittenField {
  std::string name;
  WrittenType type;
  std::vector<std::uint32_t> sizes;  ///< of an array, the outermost first
  bool optional = false;
  bool key = false;
};

/// A type as a schema writes it, with names that are not looked up yet.
struct Definition {
  enum class Kind { kStruct, kAlias, kEnum, kOther };
  Kind kind = Kind::kStruct;
  std::string scope;  ///< the modules that it is in: "geometry_msgs::msg"
  wire::Extensibility extensibility = wire::Extensibility::kFinal;
  std::vector<WrittenField> fields;  ///< of a struct; of an alias the one that it stands for
  std::vector<wire::TypeConstant> constants;  ///< of an enum
  std::string word;                           ///< of another kind: "union"
};

/// By the whole name: "geometry_msgs::msg::Point".
using Definitions = std::map<std::string, Definition, std::less<>>;

/// Returns the type of that whole name. Errors: it is not defined, or is made of what cannot be
/// decoded; the error is a clause that the type's name can stand before, such as "holds a union".
[[nodiscard]] Result<wire::Type> make_type(const Definitions& definitions, const std::string& name);

/// Returns the size of a primitive value [bytes].
[[nodiscard]] int primitive_bytes(wire::TypeKind kind) noexcept;

}  // namespace galilean::monitor
