// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/command_line/description.h"

namespace galilean::front {

/// Returns an option's names and value in roff, such as "-h, --help" or "--port INT".
[[nodiscard]] std::string option_term(const OptionDescription& option);
/// Returns an argument in roff as it stands in a synopsis, such as "FILE..." or "[COMPONENT]".
[[nodiscard]] std::string argument_term(const OptionDescription& argument);
/// Returns all that there is to say of an option: its help, range, choices and default.
[[nodiscard]] std::string option_sentences(const OptionDescription& option);
/// Returns the text with a full stop at its end, if none of . ! ? is there.
[[nodiscard]] std::string as_sentence(const std::string& text);

}  // namespace galilean::front
