// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/dashboard.h"

#include <algorithm>
#include <utility>

namespace galilean::monitor::top {
namespace {

constexpr int kWheel = 3;

}  // namespace

Dashboard::Dashboard(const Parts& parts, std::string chosen)
    : model_(parts.model),
      history_(parts.history),
      clock_(parts.clock),
      pusher_(parts.pusher),
      notices_(parts.clock),
      steering_(parts.model, parts.clock, parts.voice, notices_),
      curves_(parts.history) {
  choice_.robot = std::move(chosen);
  is_settled_ = !choice_.robot.empty();
  steering_.ask_before_orders(
      [this](const std::string& robot, bool all) { return may_steer(robot, all); });
}

void Dashboard::update() {
  const Time now = clock_.now();
  board_.update(finder_.find(model_, now), now);
  settle(now);
  steering_.update();
  if (auto refusal = pusher_.take_lease_refusal(); !refusal.empty())
    notices_.tell_of_now(std::move(refusal));
}

void Dashboard::settle(Time now) {
  constexpr Duration kAllAreHeard = std::chrono::seconds(2);
  const auto& robots = model_.team().robots();
  if (is_settled_ || robots.empty()) return;
  choice_.robot = robots.begin()->first;
  if (!first_heard_) first_heard_ = now;
  is_settled_ = now - *first_heard_ >= kAllAreHeard;
}

void Dashboard::choose(std::size_t number) {
  const View shown = view();
  if (number < shown.robots.size()) choice_.robot = shown.robots[number].status.name;
  scrolls_ = {};
}

void Dashboard::move(int step) {
  const View shown = view();
  const auto now = static_cast<int>(shown.chosen);
  if (now + step >= 0) choose(static_cast<std::size_t>(now + step));
}

void Dashboard::scroll(Panel panel, int lines) {
  if (panel == Panel::kTeam) return move(lines > 0 ? 1 : -1);
  if (panel == Panel::kMachine) scrolls_.machine += lines;
  if (panel == Panel::kVariables) scrolls_.variables += lines;
  if (panel == Panel::kWhy) scrolls_.why += lines;
}

void Dashboard::click(const Press& press) {
  const auto at = std::ranges::find_if(regions_, [&](const Region& region) {
    return region.area.contains(press.row, press.column);
  });
  if (at == regions_.end()) return;
  if (press.key == Key::kWheelUp) return scroll(at->panel, -kWheel);
  if (press.key == Key::kWheelDown) return scroll(at->panel, kWheel);
  if (!at->state.empty()) choice_.state = at->state;
  if (at->robot.empty()) return;
  choice_.robot = at->robot;
  scrolls_ = {};
}

void Dashboard::go_to(std::optional<Time> instant) {
  const Time first = history_.begin();
  if (instant && *instant >= clock_.now()) instant.reset();
  instant_ = instant ? std::optional(std::max(*instant, first)) : std::nullopt;
  past_ = instant_ ? std::make_unique<Past>(history_, *instant_) : nullptr;
}

void Dashboard::go_back(Duration step) {
  go_to(instant_.value_or(clock_.now()) - step);
}

void Dashboard::acknowledge_first() {
  if (!shown_alarms_.empty()) board_.acknowledge(shown_alarms_[0].keys);
}

void Dashboard::acknowledge_shown() {
  for (const auto& line : shown_alarms_) board_.acknowledge(line.keys);
}

}  // namespace galilean::monitor::top
