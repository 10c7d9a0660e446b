// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <span>

#include "core/wire/messages.h"
#include "robot/executive/executive.h"
#include "robot/inputs/outcome_digests.h"
#include "robot/rerun/recorded_devices.h"

namespace galilean::robot {

/// The real executive, which gets in each tick what a recording says that it got. The seed and the
/// period of ticks are those of the first tick.
class RecordedRobot {
 public:
  /// Requires: `components` outlives this.
  RecordedRobot(const Registry& components, const msg::TickInputs& first);
  RecordedRobot(const RecordedRobot&) = delete;
  RecordedRobot& operator=(const RecordedRobot&) = delete;

  /// Goes on from what the executive remembered at the end of the tick of `inputs`, while this
  /// program ran. Errors: the program cannot be built here, or it is another one.
  [[nodiscard]] Result<void> adopt(bhdl::Program program, const msg::TickInputs& inputs,
                                   std::span<const std::uint8_t> rgb,
                                   std::span<const std::uint64_t> memory);
  /// Lets the program take over in the next tick. Errors: it cannot be built here.
  [[nodiscard]] Result<void> load(bhdl::Program program, const msg::GivenProgram& given);
  /// Runs the tick, but for `inputs.program` and the pixels. `rgb` is a picture that is new, or
  /// empty. Errors: an order to go back is refused.
  [[nodiscard]] Result<void> tick(const msg::TickInputs& inputs, std::span<const std::uint8_t> rgb);

  /// Returns what the newest tick led to. Programs have the numbers of the recording.
  [[nodiscard]] const TickOutcome& outcome() const noexcept { return watch_.outcome; }
  /// Returns null while no program runs.
  [[nodiscard]] const RunningProgram* program() const noexcept { return executive_.program(); }
  [[nodiscard]] std::string_view state_name() const noexcept { return executive_.state_name(); }
  /// Returns the state whose perceptual schemas ran in the newest tick.
  [[nodiscard]] std::uint32_t perceived_in() const noexcept;
  [[nodiscard]] Time now() const noexcept { return clock_.now(); }

 private:
  /// Stands still in a tick until its end.
  class Stopwatch final : public Clock {
   public:
    void next_takes(Duration tick_time) noexcept { tick_time_ = tick_time; }
    [[nodiscard]] Time now() const noexcept override {
      began_ = !began_;
      return began_ ? Time{} : Time{tick_time_};
    }

   private:
    Duration tick_time_{};
    mutable bool began_ = false;
  };

  struct Watch final : TickObserver {
    void on_event(const Event& event) noexcept override;
    void on_tick(const TickView& view) noexcept override;

    TickOutcome outcome;
    std::uint32_t fired = Event::kNone;
    std::uint32_t left_state = 0;  ///< where a condition fired
    OutcomeDigests digests;
  };

  [[nodiscard]] ProgramId own_number(ProgramId recorded) const noexcept;
  void obey(const msg::TickInputs& inputs);
  void give(const msg::TickInputs& inputs, std::span<const std::uint8_t> rgb);

  SteppedClock clock_;
  Stopwatch stopwatch_;
  RecordedDevices devices_;
  Watch watch_;
  /// The recorded numbers of programs by those that they have here: programs that ran before the
  /// beginning have none.
  std::map<ProgramId, ProgramId> recorded_numbers_;
  Executive executive_;
};

}  // namespace galilean::robot
