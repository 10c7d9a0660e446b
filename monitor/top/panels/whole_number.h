// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::monitor::top {

/// Returns the whole number nearest to `number` between `least` and `most`, whatever came over the
/// network: `least` for NaN.
[[nodiscard]] int whole_number(double number, int least, int most) noexcept;

}  // namespace galilean::monitor::top
