// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace galilean::expect {

/// Returns a time such as "0.25 s", to the millisecond.
[[nodiscard]] std::string duration_text(std::int64_t duration_ns);
/// Returns a number with six digits at most, such as "0.31".
[[nodiscard]] std::string short_number(double number);

}  // namespace galilean::expect
