// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/hold_keeper.h"

#include <utility>

#include "core/cut_text.h"
#include "core/visible_text.h"

namespace galilean::robot {
namespace {

constexpr const char* kHeldSubject = "held";
/// The name of who ordered a hold comes from anybody in the domain.
constexpr std::size_t kMostHolderBytes = 64;

}  // namespace

HoldKeeper::HoldKeeper(const TelemetrySource& source, const BreakDesk& desk,
                       ThreadProblems& problems)
    : source_(source),
      desk_(desk),
      problems_(problems),
      is_held_since_before_(!source.held_by.empty()),
      held_by_(source.held_by),
      out_of_service_(!source.executive.in_service()) {
  if (is_held_since_before_)
    problems_.note(kHeldSubject, source.held_by +
                                     " held it when the robot program died and was started again; "
                                     "resume it.");
}

void HoldKeeper::on_round(const Snapshot& newest) {
  if (newest.tick == 0) return;
  if (is_held_since_before_ && newest.standstill.hold != Hold::kOperator) {
    is_held_since_before_ = false;
    problems_.note(kHeldSubject, "");
  }
  std::string holder = holder_in(newest);
  if (holder == held_by_ && newest.out_of_service == out_of_service_) return;
  held_by_ = std::move(holder);
  out_of_service_ = newest.out_of_service;
  if (source_.keep_orders) source_.keep_orders(held_by_, out_of_service_);
}

std::string HoldKeeper::holder_in(const Snapshot& newest) const {
  const Hold hold = newest.standstill.hold;
  if (is_stop(hold)) return "a break point";
  if (hold != Hold::kOperator) return "";
  const std::string holder = visible(desk_.held_by());
  return holder.empty() ? "an operator" : std::string(cut_text(holder, kMostHolderBytes));
}

}  // namespace galilean::robot
