// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/succession.h"

namespace galilean::robot {

/// Returns what is held against the running program. Without a last good program the verdict is
/// empty, because nothing could take its place.
Verdict Succession::pending_fault() noexcept {
  Verdict verdict = probation_.failed() ? probation_.verdict() : Verdict{};
  while (const auto order = intake_.take_order())
    if (verdict.fault == Fault::kNone && order->program == running_id())
      verdict = {.fault = Fault::kOrdered, .reason = order->reason};
  return last_good_ ? verdict : Verdict{};
}

/// Returns the program that takes over. An operator who rolls back wants the program that ran
/// before. After a failure no unproven program is trusted.
std::unique_ptr<RunningProgram> Succession::predecessor(Fault fault) noexcept {
  if (fault == Fault::kOrdered && unproven_) return std::move(unproven_);
  retire(std::move(unproven_));
  return std::move(last_good_);
}

/// Keeps `replaced` as a program to go back to. Returns the program that it supersedes, which
/// nobody needs any more.
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
