// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean {

// How a change of state is called, by the names of the state that is left and the one that is
// entered. An empty name stands for any state. The page has the same words: changeWords in
// web/src/model/breaks.ts. web/tests/fixture/state_changes.txt holds the two together.

/// Returns "wander -> grab", "on entering grab", "on leaving wander" or "at any change of state".
[[nodiscard]] std::string change_words(std::string_view from, std::string_view to);
/// Returns the same as the place of something: "at wander -> grab", "on entering grab".
[[nodiscard]] std::string place_words(std::string_view from, std::string_view to);

}  // namespace galilean
