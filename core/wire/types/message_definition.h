// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"
#include "core/wire/types/type_description.h"

namespace galilean::wire {

/// Returns the definition of a ROS 2 message in the language of .msg files, followed by those of
/// the messages that it is made of, as MCAP's schema encoding "ros2msg" has it. Constants and
/// comments are not part of a type, and are missing.
/// Errors: the type holds what no .msg file can say, such as an enum. The error is a clause.
[[nodiscard]] Result<std::string> message_definition(const Type& type);

}  // namespace galilean::wire
