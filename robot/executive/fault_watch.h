// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "core/clock.h"
#include "robot/executive/event.h"
#include "robot/executive/holding.h"

namespace galilean::robot {

/// What went wrong with a robot, so that it is held until somebody lets it go on.
enum class FaultCause : std::uint8_t {
  kNone,
  kSerialLine,  ///< the board did not answer
  kBoard,       ///< so it was, and the board was restarted meanwhile, or is another one
  kMotorDrive,
  kCamera,
  kStall,       ///< the control loop stood still
  kRestart,     ///< the robot program died while the robot ran, and was started again
  kUnknownEnd,  ///< it is not known whether that was so
  kNamesake,    ///< another robot of this name was there when this one started
};

/// A fault for which a robot is held.
struct FaultReport {
  FaultCause cause = FaultCause::kNone;
  Duration lasted{};  ///< so far, or until it was over; without meaning from kRestart on
  bool over = false;

  bool operator==(const FaultReport&) const = default;
};

/// Returns whether a bumper ends the hold after such a fault. Whoever pushes the bumper of a second
/// robot of one name does not make it the only one.
[[nodiscard]] constexpr bool ends_at_a_bumper(FaultCause cause) noexcept {
  return cause != FaultCause::kNamesake;
}

/// Decides when a robot is held after a fault, so that nothing moves unasked when a cable is
/// plugged in again. A fault shorter than kShortest holds nobody, but one that comes back before
/// the device was well for so long goes on, and what it lasted is added up: a loose plug is no
/// series of short faults. A device that has not answered yet is no fault: who starts a robot waits
/// for it. It belongs to the control loop.
class FaultWatch {
 public:
  static constexpr Duration kShortest = std::chrono::seconds(1);

  enum class Verdict : std::uint8_t { kNothing, kHold, kLetGo };

  /// What a tick knows when it begins.
  struct Inputs {
    Time now{};
    Duration since_last_tick{};  ///< 0 in the first tick
    Duration tick_period{};
    DeviceHealth health;  ///< in the tick before, as all that follows
    bool uses_camera = false;
    Time board_heard{};       ///< when the board's newest status came; 0: none yet
    Time camera_heard{};      ///< when the newest picture was taken; 0: none yet
    std::uint32_t epoch = 0;  ///< restarts and exchanges of the board
    std::uint8_t bumpers = 0;
    Hold hold = Hold::kNone;
  };

  /// Returns kLetGo when somebody pushes a bumper of a robot that is held after a fault that is
  /// over, unless its cause says that no bumper does. A bumper that was pressed all the while does
  /// not count.
  [[nodiscard]] Verdict judge(const Inputs& inputs) noexcept;
  /// Notes a fault that is known from elsewhere and is over.
  void note(FaultCause cause) noexcept;
  /// Returns the last fault; its cause is kNone when somebody let the robot go on after it.
  [[nodiscard]] const FaultReport& report() const noexcept { return report_; }

 private:
  [[nodiscard]] FaultCause missing_device(const Inputs& inputs) const noexcept;
  [[nodiscard]] Verdict judge_missing(FaultCause missing, const Inputs& inputs) noexcept;
  [[nodiscard]] Verdict judge_well(const Inputs& inputs) noexcept;
  void begin_fault(FaultCause missing, const Inputs& inputs) noexcept;
  void end_fault(const Inputs& inputs) noexcept;
  void forget() noexcept;

  FaultReport report_;
  DeviceHealth answered_;      ///< which devices have ever answered
  std::optional<Time> began_;  ///< of the fault that goes on
  FaultCause missing_ = FaultCause::kNone;
  Duration lasted_before_{};  ///< in the earlier parts of a fault that comes and goes
  Time ended_{};              ///< when the newest of them did
  Time last_well_{};
  std::uint32_t last_epoch_ = 0;
  bool pressed_ = true;  ///< a bumper is pressed, or may have been while nobody could tell
};

}  // namespace galilean::robot
