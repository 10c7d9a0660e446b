// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace galilean::monitor::top {

/// Returns the last `width` numbers as blocks between their least and their greatest, a cell each:
/// "▁▁▃█". Numbers that are none are blanks. The curve stands at the right.
[[nodiscard]] std::string sparkline(const std::vector<double>& numbers, int width);

}  // namespace galilean::monitor::top
