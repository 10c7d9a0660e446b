// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean {

/// The files or folders that a value names, so that a shell can offer them.
struct ValueFiles {
  enum class Kind { kNone, kFile, kFolder };
  Kind kind = Kind::kNone;
  std::string extension;  ///< ".bhdl" where only such files are wanted; empty: any
  std::string shipped;  ///< the folder of share/galilean whose files go by bare names; empty: none
};

/// One option, or one argument by position.
struct OptionDescription {
  std::vector<std::string> names;  ///< such as "-h" and "--help"; empty for an argument by position
  std::string argument;            ///< such as "FILE"; empty for an option
  std::string help;
  std::string value;                  ///< such as "INT"; empty for a flag
  std::string range;                  ///< such as "from 1 to 16"; empty if any is accepted
  std::string default_value;          ///< empty if there is none to show
  std::vector<std::string> choices;   ///< the value must be one of these, unless there are none
  std::vector<std::string> examples;  ///< values that a shell offers, among others
  ValueFiles files;
  bool required = false;
  int least_values = 0;
  int most_values = 0;  ///< 0 for a flag
};

/// A program's whole command line, or that of one of its commands.
struct CommandDescription {
  std::string name;  ///< as users type it, such as "galilean programs list"
  std::string help;
  std::string footer;
  bool takes_outer_options = false;  ///< the options of the command around it may stand behind it
  bool requires_command = false;
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;
  std::map<std::string, std::string> exit_codes;  ///< what differs from exit_code.h
};

/// Hidden from --help. A program whose last argument it is prints its CommandDescription as JSON.
inline constexpr const char* kDescribeCommandLine = "--describe-command-line";

/// Returns the description as JSON, in one line.
[[nodiscard]] std::string description_to_json(const CommandDescription& command);
/// Reads what description_to_json wrote. Errors: the text is nothing of the kind.
[[nodiscard]] Result<CommandDescription> description_from_json(const std::string& text);

}  // namespace galilean
