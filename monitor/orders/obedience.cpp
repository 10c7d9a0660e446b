// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/obedience.h"

namespace galilean::monitor {
namespace {

std::string success_of(Operator::Word word, const RobotReport& before, const RobotReport& now) {
  switch (word) {
    case Operator::Word::kHold:
      return "stands still";
    case Operator::Word::kDecommission:
      return "is out of service";
    case Operator::Word::kCommission:
      return "is in service again";
    case Operator::Word::kStart:
      return before.state.state + " → " + now.state.state;
    case Operator::Word::kStep:
      return "goes on until its next change of state";
    case Operator::Word::kResume:
      break;
  }
  return before.stopped_by.empty() ? "goes on" : "goes on; it was stopped by " + before.stopped_by;
}

}  // namespace

bool complied(Operator::Word word, const RobotReport& before, const RobotReport& now) {
  switch (word) {
    case Operator::Word::kHold:
      return now.state.held && now.stopped_by.empty();
    case Operator::Word::kResume:
    case Operator::Word::kStep:
      return !now.state.held;
    case Operator::Word::kDecommission:
      return now.state.out_of_service;
    case Operator::Word::kCommission:
      return !now.state.out_of_service;
    case Operator::Word::kStart:
      break;
  }
  return now.state.transitions > before.state.transitions;
}

std::string outcome_of(Operator::Word word, const RobotReport& before, const RobotReport& now) {
  if (complied(word, before, now)) return success_of(word, before, now);
  if (word != Operator::Word::kStart) return "did not answer; try again";
  return "its bumper was pushed, but it stays in " + now.state.state;
}

}  // namespace galilean::monitor
