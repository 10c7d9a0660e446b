// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace galilean::monitor {

/// The steps that a program goes through before every target runs it, in their order.
enum class StepKind : std::uint8_t {
  kCheck,   ///< checks it against each target's catalog
  kTry,     ///< tries it in simulation, beside the program that runs
  kCanary,  ///< lets one robot run it for a probation
  kRest     ///< sends it to all the others
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
  kInterrupted,  ///< its monitor ended before the push did
  kToldLater,    ///< it was interrupted or failed, and then its robots told that they run it
  kForeign       ///< made without this monitor, which does not know how it ended
};

/// How far a push has come.
struct Progress {
  PushState state = PushState::kRunning;
  std::vector<Step> steps = {};
  nlohmann::json trial = nullptr;  ///< the trial's figures; null while there are none
  /// When the robots' word came that made it kToldLater, since the Unix epoch; 0: none did.
  std::int64_t told_ns = 0;
};

}  // namespace galilean::monitor
