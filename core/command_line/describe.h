// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/command_line/option_notes.h"

namespace galilean {

/// Returns the description of `app` and of all its commands.
[[nodiscard]] CommandDescription describe(const CLI::App& app, const CommandLineNotes& notes);

/// Returns the description that the arguments ask for: kDescribeCommandLine behind the names of
/// commands, or behind none. Returns nothing if they ask for no description.
[[nodiscard]] std::optional<CommandDescription> asked_description(const CLI::App& app,
                                                                  const CommandLineNotes& notes,
                                                                  int count,
                                                                  const char* const* arguments);

}  // namespace galilean
