// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/obedience.h"

namespace galilean::monitor {
namespace {

std::string success_of(Operator::Word word, const Before& before, const msg::RobotState& now) {
  switch (word) {
    case Operator::Word::kHold:
      return "stands still";
    case Operator::Word::kDecommission:
      return "is out of service";
    case Operator::Word::kCommission:
      return "is in service again";
    case Operator::Word::kStart:
      return before.state.state + " → " + now.state;
    case Operator::Word::kStep:
      return "goes on until its next change of state";
    case Operator::Word::kResume:
      break;
  }
  return before.stopped_by.empty() ? "goes on" : "goes on; it was stopped by " + before.stopped_by;
}

}  // namespace

bool complied(Operator::Word word, const Before& before, const msg::RobotState& now) {
  switch (word) {
    case Operator::Word::kHold:
      return now.held;
    case Operator::Word::kResume:
    case Operator::Word::kStep:
      return !now.held;
    case Operator::Word::kDecommission:
      return now.out_of_service;
    case Operator::Word::kCommission:
      return !now.out_of_service;
    case Operator::Word::kStart:
      break;
  }
  return now.transitions > before.state.transitions;
}

std::string outcome_of(Operator::Word word, const Before& before, const msg::RobotState& now) {
  if (complied(word, before, now)) return success_of(word, before, now);
  return word == Operator::Word::kStart ? "its bumper was pushed, but it stays in " + now.state
                                        : "did not answer; try again";
}

}  // namespace galilean::monitor
