// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "core/wire/ros_time.h"
#include "monitor/expect/judge/judge.h"
#include "monitor/expect/language/parser.h"

namespace galilean::expect {

/// A recording that a test makes, sample by sample. Its times are in seconds from its start.
class Scene {
 public:
  explicit Scene(std::string_view text, JudgeOptions options = {})
      : parsed_(parse("a.expect", text)), judge_(parsed_.expectations, options) {
    for (const auto& each : parsed_.diagnostics) ADD_FAILURE() << bhdl::format(each);
  }

  [[nodiscard]] static std::int64_t at(double s) {
    return 1'700'000'000'000'000'000 + static_cast<std::int64_t>(std::llround(s * 1e9));
  }

  /// A state message. One that has another state than before counts as a transition.
  void state(double s, const std::string& name, const std::string& robot = "io") {
    auto& state = states_[robot];
    if (!state.state.empty() && state.state != name) ++state.transitions;
    state.state = name;
    send_state(s, robot);
  }
  /// A transition message, and the state message that comes with it.
  void transition(double s, const std::string& to, const std::string& robot = "io") {
    auto& state = states_[robot];
    msg::Transition transition;
    transition.stamp = wire::ros_time(at(s));
    transition.robot = robot;
    transition.number = ++state.transitions;
    transition.from_state = state.state;
    transition.to_state = state.state = to;
    transition.cause = "bumpers[0] became 1";
    judge_.sample(at(s), transition);
    send_state(s, robot);
  }
  void send_state(double s, const std::string& robot = "io") {
    auto& state = states_[robot];
    state.robot = robot;
    state.stamp = wire::ros_time(at(s));
    ++state.tick;
    judge_.sample(at(s), state);
  }
  /// Sends states ten times a second from one time up to another.
  void states(double from_s, double to_s, const std::string& name,
              const std::string& robot = "io") {
    for (int i = 0; from_s + 0.1 * i < to_s - 1e-9; ++i) state(from_s + 0.1 * i, name, robot);
  }
  void trash(double s, double certainty, double decay_per_s, bool valid = true) {
    msg::Variables variables;
    variables.robot = "io";
    auto& item = variables.items.emplace_back();
    item.name = "trash";
    item.type = msg::Variable_Constants::LOCATE;
    item.valid = valid;
    item.certainty = static_cast<float>(certainty);
    item.decay_per_s = static_cast<float>(decay_per_s);
    item.values = {3, 4, 0, 0, 0, 0.1};
    judge_.sample(at(s), variables);
  }
  void score(double s, double points) {
    msg::Score score;
    score.points = points;
    judge_.sample(at(s), score);
  }
  msg::RobotState& robot(const std::string& name = "io") { return states_[name]; }
  Judge& judge() { return judge_; }

  std::vector<Verdict> end(double s) { return judge_.finish(at(0), at(s)).verdicts; }
  /// Returns the finding of the only claim.
  Finding finding(double end_s) {
    auto verdicts = end(end_s);
    EXPECT_EQ(verdicts.size(), 1U);
    return verdicts.empty() ? Finding{} : std::move(verdicts.front().finding);
  }

 private:
  Parsed parsed_;
  Judge judge_;
  std::map<std::string, msg::RobotState> states_;
};

}  // namespace galilean::expect
