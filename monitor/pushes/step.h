// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace galilean::monitor {

/// What a program goes through before every target runs it, in this order.
enum class StepKind : std::uint8_t {
  kCheck,   ///< against what each target can do
  kTry,     ///< in simulation, beside the program that runs
  kCanary,  ///< on one robot, for its probation
  kRest     ///< on all the others
};

enum class StepState : std::uint8_t { kWaiting, kRunning, kDone, kFailed, kCancelled, kLeftOut };

/// One step of a push.
struct Step {
  StepKind kind = StepKind::kCheck;
  StepState state = StepState::kWaiting;
  std::string detail = {};  ///< one sentence; empty where there is nothing to say
};

enum class PushState : std::uint8_t {
  kRunning,
  kDone,
  kFailed,
  kCancelled,
  kInterrupted,  ///< its monitor ended before it did
  kForeign       ///< not made through this monitor, which does not know how it ended
};

/// How far a push has come, as it is told and remembered.
struct Progress {
  PushState state = PushState::kRunning;
  std::vector<Step> steps = {};
  nlohmann::json trial = nullptr;  ///< what the trial found; null while it found nothing
};

}  // namespace galilean::monitor
