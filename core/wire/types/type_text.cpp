// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/type_text.h"

#include <array>
#include <set>

#include "core/visible_text.h"

namespace galilean::wire {
namespace {

/// In the order of TypeKind.
constexpr std::array kPrimitiveWords{
    "boolean",        "octet", "int8",          "char",      "short",
    "unsigned short", "long",  "unsigned long", "long long", "unsigned long long",
    "float",          "double"};

std::string bound_text(const TypeDescription& type, const char* before) {
  return type.bounds.empty() ? "" : before + std::to_string(type.bounds.front());
}

std::string sizes_text(const TypeDescription& type) {
  std::string text;
  if (type.kind == TypeKind::kArray)
    for (const auto size : type.bounds) text += "[" + std::to_string(size) + "]";
  return text;
}

/// Returns how a field names its type.
std::string use_of(const TypeDescription& type) {
  if (is_primitive(type.kind)) return kPrimitiveWords.at(static_cast<std::size_t>(type.kind));
  switch (type.kind) {
    case TypeKind::kString:
      return type.bounds.empty() ? "string" : "string" + bound_text(type, "<") + ">";
    case TypeKind::kSequence: {
      const auto inside =
          use_of(*type.element) + sizes_text(*type.element) + bound_text(type, ", ");
      return "sequence<" + inside + (inside.ends_with('>') ? " >" : ">");  // >> is a shift
    }
    case TypeKind::kArray:  // its sizes stand behind the field's name
      return use_of(*type.element);
    default:
      return visible(type.name);
  }
}

std::string field_text(const TypeMember& member) {
  return use_of(*member.type) + " " + visible(member.name) + sizes_text(*member.type) + ";\n";
}

std::string struct_text(const TypeDescription& type) {
  std::string text;
  for (const auto& member : type.members) {
    text += "  ";
    if (member.key) text += "@key ";
    if (member.optional) text += "@optional ";
    if (type.extensibility == Extensibility::kMutable)
      text += "@id(" + std::to_string(member.id) + ") ";
    text += field_text(member);
  }
  return text;
}

/// Returns the label as IDL writes it, for which an enum has names.
std::string label_text(const TypeDescription& selector, std::int32_t label) {
  for (const auto& constant : selector.constants)
    if (selector.kind == TypeKind::kEnum && constant.value == label) return visible(constant.name);
  if (selector.kind == TypeKind::kBoolean) return label ? "TRUE" : "FALSE";
  return std::to_string(label);
}

std::string union_text(const TypeDescription& type) {
  std::string text;
  for (const auto& member : type.members) {
    for (const auto label : member.labels)
      text += "  case " + label_text(*type.element, label) + ":\n";
    if (member.otherwise) text += "  default:\n";
    text += "    " + field_text(member);
  }
  return text;
}

std::string constants_text(const TypeDescription& type, const char* annotation) {
  std::string text;
  for (const auto& constant : type.constants)
    text += (text.empty() ? "  @" : ",\n  @") + std::string(annotation) + "(" +
            std::to_string(constant.value) + ") " + visible(constant.name);
  return text + "\n";
}

std::string extensibility_text(Extensibility extensibility) {
  constexpr std::array kWords{"@final ", "@appendable ", "@mutable "};
  return kWords.at(static_cast<std::size_t>(extensibility));
}

/// Returns the definition without its modules.
std::string definition_text(const TypeDescription& type, const std::string& name) {
  const std::string bits = "@bit_bound(" + std::to_string(type.bytes * 8) + ") ";
  switch (type.kind) {
    case TypeKind::kEnum:
      return bits + "enum " + name + " {\n" + constants_text(type, "value") + "};\n";
    case TypeKind::kBitmask:
      return bits + "bitmask " + name + " {\n" + constants_text(type, "position") + "};\n";
    case TypeKind::kUnion:
      return extensibility_text(type.extensibility) + "union " + name + " switch (" +
             use_of(*type.element) + ") {\n" + union_text(type) + "};\n";
    default:
      return extensibility_text(type.extensibility) + "struct " + name + " {\n" +
             struct_text(type) + "};\n";
  }
}

std::string in_modules(const TypeDescription& type) {
  std::string open, close, name = visible(type.name);
  for (std::size_t at; (at = name.find("::")) != name.npos; name.erase(0, at + 2)) {
    open += "module " + name.substr(0, at) + " { ";
    close += "}; ";
  }
  if (open.empty()) return definition_text(type, name);
  open.back() = '\n';
  close.back() = '\n';
  return open + definition_text(type, name) + close;
}

/// Appends the definitions of the types that are in none of `done`, each after those it needs.
void add_definitions(const TypeDescription& type, std::set<std::string>& done, std::string& text) {
  if (!type.name.empty() && done.contains(type.name)) return;
  if (type.element) add_definitions(*type.element, done, text);
  for (const auto& member : type.members) add_definitions(*member.type, done, text);
  if (type.name.empty() || !done.insert(type.name).second) return;
  text += (text.empty() ? "" : "\n") + in_modules(type);
}

}  // namespace

std::string type_text(const Type& type) {
  std::set<std::string> done;
  std::string text;
  add_definitions(*type, done, text);
  return text;
}

}  // namespace galilean::wire
