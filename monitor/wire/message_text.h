// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::monitor {

/// Returns the field at a path such as "stamp.sec" or "variables[0].name", or nullptr if an index
/// is beyond the end of its list. Errors: the message has no field of that name; the error says
/// which it has.
[[nodiscard]] Result<const MessageTree*> find_field(const MessageTree& message,
                                                    std::string_view path);

/// Returns the message as readable text, like YAML, one field a line. Texts from the network become
/// visible. Long lists of numbers are cut, with the count of what is left out.
[[nodiscard]] std::string readable_text(const MessageTree& message);

}  // namespace galilean::monitor
