// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "monitor/top/dashboard.h"
#include "monitor/top/sheets/break_sheet.h"

namespace galilean::monitor::top {

void Dashboard::move_in_machine(int step) {
  const auto states = view().machine.states;
  if (states.empty()) return notices_.tell("It is not known yet which states there are.");
  const auto chosen = std::ranges::find_if(states, &ShownState::chosen);
  auto to = std::ranges::find_if(states, &ShownState::current) - states.begin();
  if (chosen != states.end()) to = chosen - states.begin() + step;
  const auto last = static_cast<std::ptrdiff_t>(states.size()) - 1;
  choice_.state = states[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(to, 0, last))].name;
  scrolls_.machine = 0;
}

void Dashboard::toggle_break_point() {
  const std::string robot = shown_robot();
  const auto states = view().machine.states;
  const auto chosen = std::ranges::find_if(states, &ShownState::chosen);
  if (chosen == states.end())
    return notices_.tell("Choose a state with J and K first, or click on it.");
  const Robot* known = model_.team().find(robot);
  if (!known || !known->breaks) return notices_.tell(robot + " tells nothing of break points.");
  const msg::BreakPoint point{.to_state = chosen->name, .kind = msg::BreakPoint_Constants::STOP};
  const bool is_set = std::ranges::any_of(known->breaks->points, [&](const auto& each) {
    return each.from_state.empty() && each.to_state == point.to_state;
  });
  steering_.order_breaks(robot, is_set ? "remove" : "set", {point});
}

void Dashboard::open_breaks() {
  const std::string robot = shown_robot();
  if (robot.empty()) return notices_.tell("No robot is heard that could stop.");
  open(std::make_unique<BreakSheet>(model_, steering_, robot, past_ != nullptr));
}

}  // namespace galilean::monitor::top
