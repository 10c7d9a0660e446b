// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/succession.h"

namespace galilean::robot {

/// What is held against the running program, where another one can take its place.
Verdict Succession::judgement() noexcept {
  Verdict verdict = probation_.failed() ? probation_.verdict() : Verdict{};
  while (const auto order = intake_.take_order())
    if (verdict.fault == Fault::kNone && order->program == running_id())
      verdict = {.fault = Fault::kOrdered, .reason = order->reason};
  return last_good_ ? verdict : Verdict{};
}

/// The operator who takes a program off wants what ran before it; a program that failed tells that
/// nothing unproven is to be trusted.
std::unique_ptr<RunningProgram> Succession::predecessor(Fault fault) noexcept {
  if (fault == Fault::kOrdered && unproven_) return std::move(unproven_);
  retire(std::move(unproven_));
  return std::move(last_good_);
}

/// Keeps `replaced` to go back to. Returns the one that it supersedes, which nobody needs now.
std::unique_ptr<RunningProgram> Succession::keep(std::unique_ptr<RunningProgram> replaced,
                                                 bool proven) noexcept {
  if (!replaced) return nullptr;
  retire(std::move(unproven_));
  std::swap(proven ? last_good_ : unproven_, replaced);
  return replaced;
}

void Succession::begin_probation(Time now, const DeviceHealth& health) noexcept {
  probation_.begin(now, running_->description->probation, health);
}

}  // namespace galilean::robot
