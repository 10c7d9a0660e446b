// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/schemas/definitions.h"

#include <set>
#include <string_view>
#include <utility>

#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

using wire::Type;
using wire::TypeDescription;
using wire::TypeKind;

/// ROS 2 gives a struct without fields this one, because IDL knows no empty structs.
constexpr const char* kOnlyMember = "structure_needs_at_least_one_member";

constexpr std::size_t kDeepest = 64;  // types within types

Type primitive_type(TypeKind kind) {
  TypeDescription type;
  type.kind = kind;
  type.bytes = primitive_bytes(kind);
  return std::make_shared<const TypeDescription>(std::move(type));
}

/// Looks names up and makes types of definitions, each once.
class TypeMaker {
 public:
  explicit TypeMaker(const Definitions& definitions) : definitions_(definitions) {}

  Result<Type> named(const std::string& name) {
    if (const auto made = made_.find(name); made != made_.end()) return made->second;
    const auto found = definitions_.find(name);
    if (found == definitions_.end())
      return Error{"needs " + visible(name) + ", which is not there"};
    if (under_way_.size() > kDeepest) return Error{"nests too deeply"};
    if (!under_way_.insert(name).second) return Error{"holds itself"};
    auto type = make(name, found->second);
    under_way_.erase(name);
    if (type) made_.emplace(name, type.value());
    return type;
  }

 private:
  Result<Type> make(const std::string& name, const Definition& definition) {
    switch (definition.kind) {
      case Definition::Kind::kAlias:
        return of_field(definition.fields.front(), definition.scope);
      case Definition::Kind::kEnum:
        return enumeration(name, definition);
      case Definition::Kind::kOther:
        return Error{"holds a " + visible(definition.word)};
      case Definition::Kind::kStruct:
        break;
    }
    return structure(name, definition);
  }

  static Result<Type> enumeration(const std::string& name, const Definition& definition) {
    TypeDescription type;
    type.kind = TypeKind::kEnum;
    type.bytes = 4;
    type.name = name;
    type.constants = definition.constants;
    return Type(std::make_shared<const TypeDescription>(std::move(type)));
  }

  Result<Type> structure(const std::string& name, const Definition& definition) {
    TypeDescription type;
    type.kind = TypeKind::kStruct;
    type.name = name;
    type.extensibility = definition.extensibility;
    for (const auto& field : definition.fields) {
      auto made = of_field(field, definition.scope);
      if (!made) return made;
      type.members.push_back({.name = field.name,
                              .id = static_cast<std::uint32_t>(type.members.size()),
                              .type = std::move(made).value(),
                              .optional = field.optional,
                              .key = field.key});
    }
    if (type.members.empty())
      type.members.push_back({.name = kOnlyMember, .type = primitive_type(TypeKind::kByte)});
    return Type(std::make_shared<const TypeDescription>(std::move(type)));
  }

  Result<Type> of_field(const WrittenField& field, const std::string& scope) {
    auto element = of(field.type, scope);
    if (!element || field.sizes.empty()) return element;
    TypeDescription array;
    array.kind = TypeKind::kArray;
    array.bounds = field.sizes;
    array.element = std::move(element).value();
    return Type(std::make_shared<const TypeDescription>(std::move(array)));
  }

  Result<Type> of(const WrittenType& written, const std::string& scope) {
    if (written.kind == WrittenType::Kind::kPrimitive) return primitive_type(written.primitive);
    if (written.kind == WrittenType::Kind::kNamed) return named(whole_name(written.name, scope));
    TypeDescription type;
    type.kind =
        written.kind == WrittenType::Kind::kString ? TypeKind::kString : TypeKind::kSequence;
    if (written.bound) type.bounds.push_back(*written.bound);
    if (written.element) {
      auto element = of(*written.element, scope);
      if (!element) return element;
      type.element = std::move(element).value();
    }
    return Type(std::make_shared<const TypeDescription>(std::move(type)));
  }

  /// Looks a name up in its scope, then in those around it. One that is nowhere keeps its name.
  std::string whole_name(const std::string& name, std::string scope) const {
    while (!scope.empty()) {
      if (auto tried = scope + "::" + name; definitions_.contains(tried)) return tried;
      const auto outer = scope.rfind("::");
      scope.resize(outer == std::string::npos ? 0 : outer);
    }
    return name;
  }

  const Definitions& definitions_;
  std::map<std::string, Type> made_;
  std::set<std::string> under_way_;
};

}  // namespace

int primitive_bytes(wire::TypeKind kind) noexcept {
  switch (kind) {
    case TypeKind::kInt16:
    case TypeKind::kUint16:
      return 2;
    case TypeKind::kInt32:
    case TypeKind::kUint32:
    case TypeKind::kFloat:
      return 4;
    case TypeKind::kInt64:
    case TypeKind::kUint64:
    case TypeKind::kDouble:
      return 8;
    default:
      return 1;
  }
}

Result<wire::Type> make_type(const Definitions& definitions, const std::string& name) {
  return TypeMaker(definitions).named(name);
}

}  // namespace galilean::monitor
