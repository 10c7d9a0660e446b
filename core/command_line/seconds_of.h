// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"

namespace galilean {

/// Reads a time such as "10", "10s", "500ms", "2min" or "1h". Returns seconds, at least 0.
/// Errors: the text is no such time.
[[nodiscard]] Result<double> seconds_of(const std::string& text);

}  // namespace galilean
