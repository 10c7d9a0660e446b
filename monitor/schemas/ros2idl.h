// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "monitor/schemas/definitions.h"

namespace galilean::monitor {

/// Reads a schema in MCAP's encoding "ros2idl": modules, structs, aliases, enums and constants.
/// Unions, bitmasks and the like get a definition of kind kOther. Any text may be given.
/// Errors: it is no such schema; the error is a clause such as "has 'x' where a name is expected".
[[nodiscard]] Result<Definitions> parse_ros2idl(std::string_view text);

}  // namespace galilean::monitor
