// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/generate/emit_bounds.h"

#include <sstream>

namespace galilean::idl {
namespace {

/// What holds where the bounds of a field say nothing. Reals are finite, and so small that squares
/// of them are, too.
constexpr const char* kLeastReal = "-1e12";
constexpr const char* kMostReal = "1e12";
constexpr long kMostTextBytes = 65536;
constexpr long kMostEntries = 65536;
constexpr long kMostBytes = 64 << 20;

std::string check_of(std::string type) {
  for (std::size_t at; (at = type.find("::")) != std::string::npos;) type.replace(at, 2, "_");
  return "check_" + type;
}

/// Returns `text` as a literal of C++. Requires: it needs no escapes.
std::string literal(const std::string& text) {
  return "\"" + text + "\"";
}

bool is_real(const std::string& type) {
  return type == "float" || type == "double";
}

std::string number_call(const std::string& type, const FieldBounds& bounds,
                        const std::string& place) {
  const std::string low = bounds.low.empty() ? kLeastReal : bounds.low;
  const std::string high = bounds.high.empty() ? kMostReal : bounds.high;
  return "at.within<" + std::string(basic_type(type)->cpp) + ">(" + low + ", " + high + ", " +
         literal(place + " is not from " + low + " to " + high) + ");";
}

std::string text_call(const FieldBounds& bounds, long most, const std::string& place) {
  using Name = FieldBounds::Name;
  const std::string no_name = place + " is not a valid name of a robot";
  switch (bounds.name) {
    case Name::kOwn:
      return "at.own_name(" + literal(no_name) + ");";
    case Name::kRobot:
      return "at.robot_name(" + literal(no_name) + ");";
    case Name::kRobotOrEmpty:
      return "at.robot_name_or_empty(" + literal(no_name) + ");";
    case Name::kNone:
      break;
  }
  return "at.text(" + std::to_string(most) + ", " +
         literal(place + " has more than " + std::to_string(most) + " bytes") + ");";
}

/// Returns whether the field's numbers may be any, so that they can be left out at once.
bool is_unchecked(const Field& field, const FieldBounds& bounds) {
  return basic_type(field.type) && (bounds.any || (!is_real(field.type) && bounds.low.empty()));
}

/// Returns the call for one value of the field, or one entry of it.
std::string value_call(const Field& field, const FieldBounds& bounds, const std::string& place) {
  const long most = field.sequence ? kMostTextBytes : bounds.most.value_or(kMostTextBytes);
  if (field.type == "string") return text_call(bounds, most, place);
  if (basic_type(field.type)) return number_call(field.type, bounds, place);
  return check_of(field.type) + "(at);";
}

void emit_sequence(std::ostream& out, const Field& field, const FieldBounds& bounds,
                   const std::string& place) {
  const Basic* basic = basic_type(field.type);
  const bool is_bytes = basic && basic->size == 1;
  const std::string most =
      std::to_string(bounds.most.value_or(is_bytes ? kMostBytes : kMostEntries));
  const std::string count =
      "at.entries(" + most + ", " + literal(place + " has more than " + most + " entries") + ")";
  if (is_unchecked(field, bounds))
    out << "  at.skip(" << count << ", " << basic->size << ");\n";
  else
    out << "  for (auto left = " << count << "; left > 0 && at.good(); --left) "
        << value_call(field, bounds, place) << "\n";
}

void emit_field(std::ostream& out, const Struct& type, const Field& field,
                const FieldBounds& bounds) {
  const std::string place = type.name + "." + field.name;
  if (field.sequence) return emit_sequence(out, field, bounds, place);
  if (is_appended(field)) out << "  if (at.ends()) return;\n";
  const int count = field.array_size ? field.array_size : 1;
  if (is_unchecked(field, bounds))
    out << "  at.skip(" << count << ", " << basic_type(field.type)->size << ");\n";
  else if (field.array_size)
    out << "  for (int left = " << count << "; left > 0; --left) "
        << value_call(field, bounds, place) << "\n";
  else
    out << "  " << value_call(field, bounds, place) << "\n";
}

void emit_check(std::ostream& out, const Struct& type, const AllBounds& bounds) {
  const std::string name = type.module + "::" + type.name;
  const auto& fields = bounds.at(name);
  out << "void " << check_of(name) << "(msg::CdrChecker& at) {\n";
  for (const Field& field : type.fields) {
    const auto declared = fields.find(field.name);
    emit_field(out, type, field, declared == fields.end() ? FieldBounds{} : declared->second);
  }
  out << "}\n";
}

std::string ros_type(const Struct& type) {
  std::string name = type.module + "::" + type.name;
  for (std::size_t at; (at = name.find("::")) != std::string::npos;) name.replace(at, 2, "/");
  return name;
}

}  // namespace

std::string emit_bounds(const std::vector<File>& files, const AllBounds& bounds) {
  std::ostringstream out;
  out << "#include \"core/wire/bounds.h\"\n\n#include <cstdint>\n\n"
         "namespace galilean::wire {\nnamespace {\n\n";
  for (const auto& file : files)
    for (const auto& type : file.structs) emit_check(out, type, bounds);
  out << "\n}  // namespace\n\nBounds bounds_of(std::string_view ros_type) noexcept {\n";
  for (const auto& file : files)
    for (const auto& type : file.structs)
      out << "  if (ros_type == \"" << ros_type(type) << "\") return &"
          << check_of(type.module + "::" + type.name) << ";\n";
  out << "  return nullptr;\n}\n\n}  // namespace galilean::wire\n";
  return out.str();
}

}  // namespace galilean::idl
