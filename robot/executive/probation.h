// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "robot/executive/event.h"

namespace galilean::robot {

/// How long a new program is watched, and how often it may change its state.
struct ProbationRules {
  /// The most transitions that can be counted.
  static constexpr int kMostCounted = 200;

  Duration length = std::chrono::seconds(10);
  int most_transitions_per_s = 10;  ///< 1 to kMostCounted
};

/// Why a program fails its probation.
struct Verdict {
  Fault fault = Fault::kNone;
  std::uint32_t schema = Event::kNone;  ///< of kSchemaThrew
  ShortText reason;                     ///< as Event::text
};

/// Watches a new program until it has proven itself. It fails if one of its schemas throws, if
/// three ticks in a row take longer than the period, if a device is lost that answered when the
/// program took over, or if it changes its state more often within a second than the rules allow.
class Probation {
 public:
  static constexpr int kOverrunsInARow = 3;

  void begin(Time now, const ProbationRules& rules, const DeviceHealth& health) noexcept;
  void end() noexcept { active_ = false; }

  void note_schema_failure(std::uint32_t schema, const ShortText& reason) noexcept;
  void note_transition(Time now) noexcept;
  void note_tick(const DeviceHealth& health, bool overran) noexcept;

  void keep(Memory& memory) noexcept;

  [[nodiscard]] bool active() const noexcept { return active_; }
  /// Returns the first thing that went wrong.
  [[nodiscard]] const Verdict& verdict() const noexcept { return verdict_; }
  [[nodiscard]] bool failed() const noexcept { return active_ && verdict_.fault != Fault::kNone; }
  [[nodiscard]] bool passed(Time now) const noexcept { return active_ && !failed() && now >= end_; }

 private:
  void fail(const Verdict& verdict) noexcept;
  void note_health(const DeviceHealth& health) noexcept;

  bool active_ = false;
  Verdict verdict_;
  Time end_{};
  DeviceHealth healthy_before_;
  int overruns_in_a_row_ = 0;
  std::size_t most_transitions_per_s_ = 0;
  std::array<Time, ProbationRules::kMostCounted> transition_times_{};
  std::size_t transitions_ = 0;
};

}  // namespace galilean::robot
