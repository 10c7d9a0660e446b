// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/command_line/description.h"
#include "core/result.h"

namespace galilean::front {

/// One verb of `galilean`, with the command line that its program describes.
struct DescribedVerb {
  std::string name;  ///< one word or two, such as "sim ctl"
  std::string help;  ///< what `galilean help` says of it
  CommandDescription command;
};

/// Asks the programs of all verbs for their command lines.
/// Errors: a program is missing, or does not describe itself.
[[nodiscard]] Result<std::vector<DescribedVerb>> describe_verbs();

/// Returns the command line of `galilean` itself, without its verbs.
[[nodiscard]] CommandDescription describe_galilean();

/// Returns the command line of `galilean` with the verbs as its commands. A verb of two words is a
/// command of the verb that is its first word.
[[nodiscard]] CommandDescription command_tree(const std::vector<DescribedVerb>& verbs);

}  // namespace galilean::front
