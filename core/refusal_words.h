// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace galilean {

/// Returns "12 messages on /io/state were not taken: RobotState.heading_rad is not a number", a
/// sentence without its full stop. `topic` is DDS's name, such as "rt/io/state"; one that does not
/// begin so stands for several, and is not named. The page has the same words in
/// web/src/model/intake.ts.
[[nodiscard]] std::string refusal_words(std::string_view topic, std::uint64_t messages,
                                        std::string_view reason);

}  // namespace galilean
