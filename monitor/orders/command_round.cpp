// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/command_round.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "monitor/orders/break_words.h"

namespace galilean::monitor {
namespace {

constexpr Duration kFirstListener = std::chrono::seconds(1);

}  // namespace

bool CommandRound::say_at_once() {
  return !session_.wait(kFirstListener, [&] { return speaker_.listeners() > 0; }) ||
         speaker_.say(word_, whom_.robots);
}

Result<std::vector<CommandOutcome>> CommandRound::run() {
  // Who is to stand still does not wait until it is sure that another one is not there.
  const bool is_urgent = word_ == Operator::Word::kHold;
  const auto there = session_.find(whom_, is_urgent ? kFirstListener : OrderSession::kHear);
  if (!there) return there.error();
  const bool stops = is_urgent || word_ == Operator::Word::kDecommission;
  if (const auto may = session_.check_leases(whom_); !stops && !may) return may.error();
  robots_ = session_.addressed(whom_);
  note_before();
  session_.wait(OrderSession::kHear,
                [&] { return speaker_.listeners() >= static_cast<int>(there.value()); });
  said_ = said_last_ = session_.now();
  if (!speaker_.say(word_, whom_.robots)) return Error{"DDS did not accept the command; try again"};
  robots_ = session_.everyone(whom_);
  note_before();
  session_.wait(OrderSession::kAnswer, [&] {
    if (all_done()) return true;
    tell_again();
    return false;
  });
  std::vector<CommandOutcome> outcomes;
  for (const auto& robot : robots_) outcomes.push_back(outcome(robot));
  return outcomes;
}

void CommandRound::note_before() {
  for (const auto& robot : robots_) before_.try_emplace(robot, report_of(robot));
}

bool CommandRound::all_done() {
  for (const auto& robot : robots_)
    if (auto now = report_of(robot); !obeyed_.contains(robot) &&
                                     session_.has_told_since(robot, said_) &&
                                     complied(word_, before_[robot], now))
      obeyed_[robot] = std::move(now);
  return std::ranges::all_of(robots_, [&](const auto& robot) {
    return obeyed_.contains(robot) || !refusal_of(robot).empty();
  });
}

std::string CommandRound::refusal_of(const std::string& robot) const {
  const msg::BreakAnswer* answer = session_.answer_of(robot, speaker_.last_id());
  return answer ? answer->refused : "";
}

/// A robot that hangs may come back at any time. Nothing but a hold is said twice: a second push of
/// a bumper is another push.
void CommandRound::tell_again() {
  constexpr Duration kTellEach = std::chrono::milliseconds(500);
  if (word_ != Operator::Word::kHold || session_.now() - said_last_ < kTellEach) return;
  said_last_ = session_.now();
  std::vector<std::string> waiting;
  std::ranges::copy_if(robots_, std::back_inserter(waiting),
                       [&](const std::string& robot) { return !obeyed_.contains(robot); });
  (void)speaker_.say(word_, waiting);  // if DDS does not accept it, the next one makes it good
}

RobotReport CommandRound::report_of(const std::string& robot) const {
  const msg::RobotState* state = session_.state_of(robot);
  const msg::Breaks* told = session_.breaks_of(robot);
  return {state ? *state : msg::RobotState{}, told ? reason_of(*told) : ""};
}

/// A start that moves nobody is well, because a program may wait for something else.
CommandOutcome CommandRound::outcome(const std::string& robot) {
  if (const auto obeyed = obeyed_.find(robot); obeyed != obeyed_.end())
    return {robot, outcome_of(word_, before_[robot], obeyed->second), true};
  if (const auto why = refusal_of(robot); !why.empty()) return {robot, "refused: " + why, false};
  if (!session_.has_told_since(robot, said_)) return {robot, session_.silence_of(robot), false};
  return {robot, outcome_of(word_, before_[robot], report_of(robot)),
          word_ == Operator::Word::kStart};
}

}  // namespace galilean::monitor
