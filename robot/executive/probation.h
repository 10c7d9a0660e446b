#pragma once

#include <array>
#include <cstdint>

#include "robot/executive/event.h"

namespace galilean::robot {

/// Watches a new program until it has proven itself. It fails if one of its schemas throws, if
/// three ticks in a row take longer than the period, if a device is lost that answered when the
/// program took over, or if it changes its state more than ten times within a second.
class Probation {
 public:
  static constexpr int kOverrunsInARow = 3;
  static constexpr int kMostTransitionsPerSecond = 10;

  void begin(Time now, Duration length, const DeviceHealth& health) noexcept;
  void end() noexcept { active_ = false; }

  void note_schema_failure(std::uint32_t schema, const ShortText& reason) noexcept;
  void note_transition(Time now) noexcept;
  void note_tick(const DeviceHealth& health, bool overran) noexcept;

  [[nodiscard]] bool active() const noexcept { return active_; }
  /// The first thing that went wrong.
  [[nodiscard]] Fault fault() const noexcept { return active_ ? fault_ : Fault::kNone; }
  [[nodiscard]] bool passed(Time now) const noexcept {
    return active_ && fault_ == Fault::kNone && now >= end_;
  }
  /// Of kSchemaThrew: which one, and what it threw. Of kDeviceLost: which device.
  [[nodiscard]] std::uint32_t schema() const noexcept { return schema_; }
  [[nodiscard]] const ShortText& reason() const noexcept { return reason_; }

 private:
  void fail(Fault fault, std::string_view detail = {}) noexcept;
  void note_health(const DeviceHealth& health) noexcept;

  bool active_ = false;
  Fault fault_ = Fault::kNone;
  Time end_{};
  DeviceHealth healthy_before_;
  int overruns_in_a_row_ = 0;
  std::array<Time, kMostTransitionsPerSecond + 1> transition_times_{};
  std::size_t transitions_ = 0;
  std::uint32_t schema_ = Event::kNone;
  ShortText reason_;
};

}  // namespace galilean::robot
