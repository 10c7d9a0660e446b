// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/messages.h"

namespace galilean::monitor::top {

/// A variable's value in a few characters, by its type; "-" where it has none.
[[nodiscard]] std::string variable_text(const msg::Variable& variable);

}  // namespace galilean::monitor::top
