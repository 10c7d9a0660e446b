// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string_view>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// Returns the robot's answer to the order of this id, or null if it tells of none. A robot tells
/// its answers to the newest orders alone, whoever gave them.
[[nodiscard]] inline const msg::BreakAnswer* answer_to(const msg::Breaks& told,
                                                       std::string_view order_id) noexcept {
  const auto found = std::ranges::find(told.answers, order_id, &msg::BreakAnswer::id);
  return found == told.answers.end() ? nullptr : &*found;
}

}  // namespace galilean::monitor
