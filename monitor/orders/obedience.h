// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/messages.h"
#include "monitor/orders/operator.h"

namespace galilean::monitor {

/// What a robot tells of itself.
struct RobotReport {
  msg::RobotState state;
  std::string stopped_by;  ///< the break point or step that holds it, in words; empty: none
};

/// Returns whether the robot obeyed. It has obeyed a start if its program left its state. While a
/// break point or a step holds it, it has not obeyed a hold yet, because a step would let it go on.
[[nodiscard]] bool complied(Operator::Word word, const RobotReport& before, const RobotReport& now);
/// Returns what became of the command, in words such as "stands still".
[[nodiscard]] std::string outcome_of(Operator::Word word, const RobotReport& before,
                                     const RobotReport& now);

}  // namespace galilean::monitor
