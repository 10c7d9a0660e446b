// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/command_line/description.h"

namespace galilean::front {

/// Where the cursor may stand on a command line: behind `galilean` and the commands `path`.
struct Place {
  std::string path;  ///< such as "sim ctl pause"; empty behind `galilean` alone
  std::vector<const CommandDescription*> commands;
  std::vector<OptionDescription> options;    ///< those of outer commands too, where they may stand
  std::vector<OptionDescription> arguments;  ///< in the order of their positions
};

/// Returns all places of a command line. Requires: `tree` outlives them.
[[nodiscard]] std::vector<Place> places_of(const CommandDescription& tree);

/// Returns the last word of a command's name, which is what users type at its place.
[[nodiscard]] std::string last_word(const std::string& name);

/// Returns whether any number of values may follow.
[[nodiscard]] bool is_endless(const OptionDescription& option);

/// Returns the words that a value may be: the choices, the examples, and the bare names of files
/// that ship.
[[nodiscard]] std::vector<std::string> words_for(const OptionDescription& option);

/// Returns the words with a blank between each two.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

/// Returns `text` in single quotes, in which each of `special` has a backslash before it. `quote`
/// stands for a single quote.
[[nodiscard]] std::string quoted(const std::string& text, const std::string& quote,
                                 const std::string& special = {});

}  // namespace galilean::front
