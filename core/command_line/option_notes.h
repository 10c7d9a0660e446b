// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/command_line/description.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace galilean {

/// What CLI11 does not keep of an option, and a description of the command line needs.
struct OptionNotes {
  std::string range;
  std::string default_value;  ///< instead of the default of whoever asks; empty: that
  std::vector<std::string> choices;
  std::vector<std::string> examples;
  ValueFiles files;
};

/// The notes of a command line and of all its commands.
struct CommandLineNotes {
  std::map<const CLI::Option*, OptionNotes> options;
  std::map<const CLI::App*, std::map<std::string, std::string>> exit_codes;
};

}  // namespace galilean
