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
  std::uint64_t ticks = 0;  ///< that were run again, with the one that diverged
  double recorded_s = 0;    ///< the time between the first and the last of them
  std::optional<Divergence> divergence;
  /// Why nothing can be told of the tick behind those, or an empty text.
  std::string cannot_tell;
};

/// Feeds recorded ticks to the real executive and compares all that they lead to, bit by bit. With
/// another program, a second executive runs that beside the recorded one, and the two are compared.
/// It ends at the first divergence and at the first tick of which it cannot tell.
class Rerun {
 public:
  /// Requires: `components` outlives this. `other`, if it is given, takes the place of the program
  /// that the robot starts with; programs that were pushed later take over as they did.
  explicit Rerun(const Registry& components, std::optional<bhdl::Program> other = {});

  /// Takes the next tick. Those behind the end are left alone.
  void take(const msg::TickInputs& inputs);
  [[nodiscard]] const RerunResult& result() const noexcept { return result_; }

 private:
  [[nodiscard]] bool over() const noexcept {
    return result_.divergence || !result_.cannot_tell.empty();
  }
  [[nodiscard]] std::string gap_before(const msg::TickInputs& inputs) const;
  [[nodiscard]] std::string damage(const msg::TickInputs& inputs);
  [[nodiscard]] Result<void> run(const msg::TickInputs& inputs);
  [[nodiscard]] Result<void> load(const msg::GivenProgram& given);
  void compare_tick(const msg::TickInputs& inputs);

  const Registry& components_;
  std::optional<bhdl::Program> other_program_;
  std::unique_ptr<RecordedRobot> recorded_;
  std::unique_ptr<RecordedRobot> other_;  ///< null: the recorded program alone is run
  std::vector<std::uint8_t> rgb_;         ///< the newest picture
  std::uint64_t pixels_digest_ = 0;
  std::uint64_t last_tick_ = 0;
  std::int64_t first_ns_ = 0;
  RerunResult result_;
};

}  // namespace galilean::robot
