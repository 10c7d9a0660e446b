// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/rerun/divergence.h"

namespace galilean::robot {

/// What became of a run that was run again.
struct RerunResult {
  std::string robot;
  std::uint64_t first_tick = 0;  ///< the first that was compared
  std::uint64_t ticks = 0;       ///< that were compared, with the one that diverged
  double recorded_s = 0;         ///< what these took when they were recorded
  std::optional<Divergence> divergence;
  /// The first tick of which nothing can be told, though a tick before it was run again, and why;
  /// 0 and empty if there is none.
  std::uint64_t untold_tick = 0;
  std::string cannot_tell;
  std::uint64_t left_out = 0;  ///< ticks of the recording that were not compared
};

/// Feeds recorded ticks to the real executive and compares all that they lead to, bit by bit. It
/// begins with the first tick of the run or with the first from which the executive's memory is
/// recorded. Where ticks are missing or damaged it goes on from the next memory. It ends at the
/// first divergence. With another program, a second executive runs that beside the recorded one,
/// and the two are compared.
class Rerun {
 public:
  /// Requires: `components` outlives this. `other`, if it is given, takes the place of the program
  /// that runs at the beginning; programs that were pushed later take over as they did.
  explicit Rerun(const Registry& components, std::optional<bhdl::Program> other = {});

  /// Takes the next tick.
  void take(const msg::TickInputs& inputs);
  /// Returns what became of all ticks that were taken.
  [[nodiscard]] RerunResult result() const;

 private:
  void begin(const msg::TickInputs& inputs);
  void go_on(const msg::TickInputs& inputs);
  void lose(const msg::TickInputs& inputs, const std::string& why);
  [[nodiscard]] std::string damage(const msg::TickInputs& inputs);
  [[nodiscard]] Result<void> start(const msg::TickInputs& inputs);
  [[nodiscard]] Result<void> adopt(const msg::TickInputs& inputs);
  [[nodiscard]] Result<void> run(const msg::TickInputs& inputs);
  [[nodiscard]] Result<void> load(const msg::GivenProgram& given);
  [[nodiscard]] bool went_back(const msg::TickInputs& inputs) const;
  void compare_tick(const msg::TickInputs& inputs);

  const Registry& components_;
  std::optional<bhdl::Program> other_program_;
  std::unique_ptr<RecordedRobot> recorded_;  ///< null: nothing runs now
  std::unique_ptr<RecordedRobot> other_;     ///< null: the recorded program alone is run
  std::optional<bhdl::Program> replaces_;    ///< what `other_` gets in place of its next program
  bool lacks_predecessor_ = false;
  std::vector<std::uint8_t> rgb_;  ///< the newest picture
  std::uint64_t pixels_digest_ = 0;
  std::uint64_t seen_first_ = 0;  ///< the first tick of the recording
  std::uint64_t last_tick_ = 0;
  std::int64_t last_ns_ = 0;
  RerunResult result_;
};

}  // namespace galilean::robot
