// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/messages.h"
#include "monitor/orders/operator.h"

namespace galilean::monitor {

/// A robot before a command.
struct Before {
  msg::RobotState state;
  std::string stopped_by;  ///< the break point or step that holds it, in words; empty: none
};

/// Returns whether the robot obeyed. A robot has obeyed a start if its program left its state.
[[nodiscard]] bool complied(Operator::Word word, const Before& before, const msg::RobotState& now);
/// Returns what became of the command, in words such as "stands still".
[[nodiscard]] std::string outcome_of(Operator::Word word, const Before& before,
                                     const msg::RobotState& now);

}  // namespace galilean::monitor
