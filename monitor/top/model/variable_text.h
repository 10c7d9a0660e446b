// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/messages.h"

namespace galilean::monitor::top {

/// Returns a variable's value in a few characters, or "-" if the variable is invalid.
[[nodiscard]] std::string variable_text(const msg::Variable& variable);

}  // namespace galilean::monitor::top
