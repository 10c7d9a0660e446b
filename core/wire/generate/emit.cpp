// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/generate/emit.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace galilean::idl {
namespace {

std::string short_name(const std::string& type) {
  return type.substr(type.rfind(':') + 1);
}

/// Returns the name that idlc gives in C: galilean_msgs::msg::RobotState ->
/// galilean_msgs_msg_RobotState
std::string c_name(std::string type) {
  for (std::size_t at; (at = type.find("::")) != std::string::npos;) type.replace(at, 2, "_");
  return type;
}

std::string full_name(const Struct& type) {
  return type.module + "::" + type.name;
}

/// Returns the name of ROS 2 and log files: galilean_msgs::msg::RobotState ->
/// galilean_msgs/msg/RobotState
std::string ros_name(std::string type) {
  for (std::size_t at; (at = type.find("::")) != std::string::npos;) type.replace(at, 2, "/");
  return type;
}

std::string cpp_type(const std::string& type) {
  if (type == "string") return "std::string";
  const Basic* basic = basic_type(type);
  return basic ? std::string(basic->cpp) : short_name(type);
}

std::string cpp_field(const Field& field) {
  const std::string type = cpp_type(field.type);
  if (field.sequence) return "std::vector<" + type + "> " + field.name + ";";
  if (field.array_size)
    return "std::array<" + type + ", " + std::to_string(field.array_size) + "> " + field.name +
           "{};";
  return type + " " + field.name + (basic_type(field.type) ? "{};" : ";");
}

std::string in_lower_case(std::string text) {
  for (char& letter : text)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

/// Emits a file's constants, and a list of those of each group.
void emit_constants(std::ostream& out, const std::vector<Constant>& constants) {
  std::map<std::string, std::string> lists;
  for (const auto& [group, name, value] : constants) {
    out << "namespace " << group << " { inline constexpr std::uint8_t " << name << " = " << value
        << "; }\n";
    lists[group] += "{\"" + in_lower_case(name) + "\", " + name + "}, ";
  }
  for (const auto& [group, list] : lists)
    out << "namespace " << group << " { inline constexpr NamedConstant kAll[] = {" << list
        << "}; }\n";
}

void emit_struct(std::ostream& out, const Struct& type) {
  out << "struct " << type.name << " {\n";
  for (const auto& field : type.fields) out << "  " << cpp_field(field) << "\n";
  out << "  static constexpr const char* kRosType = \"" << ros_name(full_name(type)) << "\";\n";
  out << "  bool operator==(const " << type.name << "&) const = default;\n};\n";
  out << "inline void decode(CdrReader& from, " << type.name << "& to) {\n";
  for (const auto& field : type.fields)
    out << "  from." << (is_appended(field) ? "read_appended" : "read") << "(to." << field.name
        << ");\n";
  out << "}\n";
  out << "inline void encode(CdrWriter& to, const " << type.name << "& from) {\n";
  for (const auto& field : type.fields) out << "  to.write(from." << field.name << ");\n";
  out << "}\n\n";
}

/// Returns the statement that sets a field of the C struct.
std::string lend_field(const Field& field) {
  const std::string& name = field.name;
  if (field.array_size)
    return "std::copy(from." + name + ".begin(), from." + name + ".end(), to." + name + ");";
  if (field.sequence && field.type == "string")
    return "lend_strings(from." + name + ", to." + name + ", arena);";
  if (field.sequence && basic_type(field.type))
    return "lend_numbers(from." + name + ", to." + name + ");";
  if (field.sequence) return "lend_structs(from." + name + ", to." + name + ", arena);";
  if (field.type == "string")
    return "to." + name + " = const_cast<char*>(from." + name + ".c_str());";
  if (basic_type(field.type)) return "to." + name + " = from." + name + ";";
  return "lend(from." + name + ", to." + name + ", arena);";
}

/// A declared type and the file that declares it.
struct Declared {
  const File* file;
  const Struct* type;
};
using Declarations = std::map<std::string, Declared>;

Declarations declarations(const std::vector<File>& files) {
  Declarations all;
  for (const auto& file : files)
    for (const auto& type : file.structs) all[full_name(type)] = {&file, &type};
  return all;
}

/// Returns the full names of the structs among the fields of `type`, each once.
std::vector<std::string> used_by(const Struct& type, const Declarations& all) {
  std::vector<std::string> used;
  for (const auto& field : type.fields)
    if (all.contains(field.type) && std::find(used.begin(), used.end(), field.type) == used.end())
      used.push_back(field.type);
  return used;
}

/// Returns one type as ROS 2 would write its file, under the two lines that name it.
std::string resource_text(const Declared& declared, const Declarations& all) {
  const Struct& type = *declared.type;
  std::string text = std::string(80, '=') + "\nIDL: " + ros_name(full_name(type)) + "\n";
  for (const auto& used : used_by(type, all)) text += "#include \"" + ros_name(used) + ".idl\"\n";
  const std::string package = type.module.substr(0, type.module.find(':'));
  text += "module " + package + " { module msg {\n";
  const auto constants = declared.file->group_text.find(type.name + "_Constants");
  if (constants != declared.file->group_text.end()) text += constants->second;
  return text + type.text + "}; };\n";
}

void add_closure(const std::string& name, const Declarations& all,
                 std::vector<std::string>& closure) {
  if (std::find(closure.begin(), closure.end(), name) != closure.end()) return;
  closure.push_back(name);
  for (const auto& used : used_by(*all.at(name).type, all)) add_closure(used, all, closure);
}

std::string schema_text(const std::string& name, const Declarations& all) {
  std::vector<std::string> closure;
  add_closure(name, all, closure);
  std::string text;
  for (const auto& part : closure) text += resource_text(all.at(part), all);
  return text;
}

}  // namespace

std::string emit_structs(const std::vector<File>& files) {
  std::ostringstream out;
  out << "#pragma once\n\n#include <array>\n#include <cstdint>\n#include <string>\n#include "
         "<vector>\n\n"
         "#include \"core/wire/cdr.h\"\n#include \"core/wire/cdr_writer.h\"\n"
         "#include \"core/wire/constants.h\"\n\nnamespace "
         "galilean::msg {\n\n";
  for (const auto& file : files) {
    emit_constants(out, file.constants);
    for (const auto& type : file.structs) emit_struct(out, type);
  }
  out << "}  // namespace galilean::msg\n";
  return out.str();
}

std::string emit_lending_header(const std::vector<File>& files) {
  std::ostringstream out;
  out << "#pragma once\n\n#include <memory_resource>\n#include <string_view>\n\n#include "
         "\"core/wire/messages.h\"\n";
  for (const auto& file : files) out << "#include \"" << file.name << ".h\"\n";
  out << "\nnamespace galilean::msg {\n\nusing Arena = std::pmr::memory_resource;\n"
         "template <class M> struct Lent;\n";
  for (const auto& file : files)
    for (const auto& type : file.structs) {
      const std::string c = c_name(full_name(type));
      out << "template <> struct Lent<" << type.name << "> { using type = " << c << "; };\n"
          << "void lend(const " << type.name << "& from, " << c << "& to, Arena& arena);\n";
    }
  out << "\n/// What Cyclone knows a type by; nullptr if there is none of that name.\n"
         "const dds_topic_descriptor_t* descriptor_of(std::string_view ros_type) noexcept;\n"
         "\n}  // namespace galilean::msg\n";
  return out.str();
}

std::string emit_lending(const std::vector<File>& files) {
  std::ostringstream out;
  out << "#include \"core/wire/lending.h\"\n\n#include <algorithm>\n\n#include "
         "\"core/wire/lend_sequences.h\"\n\nnamespace galilean::msg {\n\n";
  for (const auto& file : files)
    for (const auto& type : file.structs) {
      out << "void lend([[maybe_unused]] const " << type.name << "& from, "
          << c_name(full_name(type)) << "& to, [[maybe_unused]] Arena& arena) {\n";
      for (const auto& field : type.fields) out << "  " << lend_field(field) << "\n";
      out << "}\n";
    }
  out << "\nconst dds_topic_descriptor_t* descriptor_of(std::string_view ros_type) noexcept {\n";
  for (const auto& file : files)
    for (const auto& type : file.structs)
      out << "  if (ros_type == \"" << ros_name(full_name(type)) << "\") return &"
          << c_name(full_name(type)) << "_desc;\n";
  out << "  return nullptr;\n}\n\n}  // namespace galilean::msg\n";
  return out.str();
}

std::string emit_schemas(const std::vector<File>& files) {
  std::ostringstream out;
  out << "#include \"core/wire/schemas.h\"\n\nnamespace galilean::wire {\nnamespace {\n\n"
         "constexpr Schema kSchemas[] = {\n";
  const Declarations all = declarations(files);
  for (const auto& [name, declared] : all) {
    out << "    {\"" << ros_name(name) << "\", \"" << declared.type->module
        << "::dds_::" << declared.type->name << "_\",\n";
    // Each line is a literal of its own, because compilers limit the length of a string literal.
    std::istringstream lines(schema_text(name, all));
    for (std::string line; std::getline(lines, line);)
      out << "     R\"IDL(" << line << ")IDL\" \"\\n\"\n";
    out << "    },\n";
  }
  out << "};\n\n}  // namespace\n\nstd::span<const Schema> schemas() noexcept { return kSchemas; "
         "}\n\n}  // namespace galilean::wire\n";
  return out.str();
}

}  // namespace galilean::idl
