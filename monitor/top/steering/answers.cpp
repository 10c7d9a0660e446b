// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/steering/answers.h"

#include <utility>

#include "monitor/orders/break_answer.h"

namespace galilean::monitor::top {
namespace {

void add(const std::string& sentence, std::string& text) {
  text += (text.empty() ? "" : "; ") + sentence;
}

std::string joined(const std::vector<std::string>& robots) {
  std::string names;
  for (const auto& robot : robots) names += (names.empty() ? "" : ", ") + robot;
  return names;
}

/// Returns the robot's answer to this order; nullptr if it has not answered.
const msg::BreakAnswer* answer_of(const Team& team, const std::string& robot,
                                  const std::string& id) {
  const Robot* known = team.find(robot);
  return known && known->breaks ? answer_to(*known->breaks, id) : nullptr;
}

}  // namespace

void Answers::expect(const std::string& id, const std::string& effect,
                     std::vector<std::string> robots, Time now) {
  open_.push_back({id, effect, std::move(robots), now});
}

void Answers::expect_refusals(const std::string& id, std::vector<std::string> robots, Time now) {
  open_.push_back({id, "", std::move(robots), now, true});
}

std::string Answers::take(const Team& team, Time now) {
  std::string told;
  for (auto& order : open_) {
    std::erase_if(order.robots, [&](const std::string& robot) {
      const msg::BreakAnswer* answer = answer_of(team, robot, order.id);
      if (!answer) return false;
      if (!answer->refused.empty())
        add(robot + " refused: " + answer->refused, told);
      else if (!order.effect.empty())
        add(robot + " " + order.effect, told);
      return true;
    });
    if (order.robots.empty() || now - order.sent < kMost) continue;
    if (!order.silence_is_consent) add(joined(order.robots) + " did not answer", told);
    order.robots.clear();
  }
  std::erase_if(open_, [](const Open& order) { return order.robots.empty(); });
  return told;
}

}  // namespace galilean::monitor::top
