// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace galilean::idl {

/// The subset of IDL that the messages are written in: modules, final structs, constants; no unions
/// and no enums (see galilean_msgs.idl for why).
struct Field {
  std::string type;  ///< "double", "string", or a struct's full name "std_msgs::msg::Header"
  bool sequence = false;
  int array_size = 0;  ///< 0: not an array
  std::string name;
};
struct Struct {
  std::string module;  ///< "galilean_msgs::msg"
  std::string name;
  std::vector<Field> fields;
  std::string text;  ///< as it stands in the file: whole lines, with the comments before it
};
struct Constant {
  std::string group;  ///< "Variable_Constants"
  std::string name;
  std::string value;
};
struct File {
  std::string name;  ///< "galilean_msgs"
  std::string text;
  std::vector<std::string> includes;  ///< names without ".idl"
  std::vector<Struct> structs;
  std::vector<Constant> constants;
  std::map<std::string, std::string> group_text;  ///< of "Variable_Constants", as Struct::text
};

/// Parses one IDL file. Errors: throws std::runtime_error with file and line if the text is not in
/// the subset.
[[nodiscard]] File parse(const std::string& name, const std::string& text);

/// The C++ type of a basic type, and its size in CDR [bytes].
struct Basic {
  std::string_view cpp;
  int size;
};
/// Returns nullptr if `type` names a struct or a string.
[[nodiscard]] const Basic* basic_type(std::string_view type);

/// Returns whether recordings of earlier releases have messages without this field, which is the
/// last one of its struct.
[[nodiscard]] bool is_appended(const Field& field);

}  // namespace galilean::idl
