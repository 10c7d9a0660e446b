// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "robot/executive/probation.h"
#include "robot/executive/program_intake.h"
#include "robot/executive/running_program.h"

namespace galilean::robot {

/// The change from one program to another, while it happens.
struct Handover {
  Event::Kind kind = Event::Kind::kStarted;  ///< kStarted, kSwapped or kRolledBack
  RunningProgram* replaced = nullptr;        ///< null for the first program; it lives until the
                                             ///< handover is over
  Verdict verdict;                           ///< why a program was rolled back
};

/// Knows which program runs, which programs it can go back to, and whether the running program has
/// proven itself. A program that replaces another is in probation. If it fails there, the last
/// program that proved itself replaces it. An order can also end a program at any time. Belongs to
/// the control loop.
class Succession {
 public:
  explicit Succession(ProgramIntake& intake) : intake_(intake) {}

  /// Is called at the start of a tick. If there is a reason to take the running program off, and
  /// one to go back to, that one takes over. Otherwise a waiting program takes over, if there is
  /// one. `install(handover)` is called when the new program runs and the old one still lives.
  /// `health` is that of the devices before this tick.
  template <class Install>
  void advance(Time now, const DeviceHealth& health, Install install) noexcept {
    if (const Verdict verdict = pending_fault(); verdict.fault != Fault::kNone)
      retire(roll_back(verdict, now, health, install));
    else if (auto next = intake_.take())
      retire(take_over(std::move(next), now, health, install));
  }

  /// Returns null before the first tick with a program.
  [[nodiscard]] RunningProgram* running() noexcept { return running_.get(); }
  [[nodiscard]] const RunningProgram* running() const noexcept { return running_.get(); }
  /// Returns 0 if no program runs.
  [[nodiscard]] ProgramId running_id() const noexcept {
    return running_ ? running_->description->id : 0;
  }

  /// Lets the program that waits run, without a word: it goes on from another run. Returns false if
  /// none waits.
  [[nodiscard]] bool adopt() noexcept {
    auto next = intake_.take();
    if (!next) return false;
    retire(std::exchange(running_, std::move(next)));
    return true;
  }
  /// Returns whether there is a program to go back to.
  [[nodiscard]] bool has_predecessor() const noexcept { return unproven_ || last_good_; }

  [[nodiscard]] Probation& probation() noexcept { return probation_; }
  [[nodiscard]] const Probation& probation() const noexcept { return probation_; }

 private:
  template <class Install>
  std::unique_ptr<RunningProgram> take_over(std::unique_ptr<RunningProgram> next, Time now,
                                            const DeviceHealth& health, Install& install) noexcept {
    const bool replaced_is_proven = !probation_.active();
    auto replaced = std::exchange(running_, std::move(next));
    if (replaced) begin_probation(now, health);
    install(Handover{replaced ? Event::Kind::kSwapped : Event::Kind::kStarted, replaced.get(), {}});
    return keep(std::move(replaced), replaced_is_proven);
  }

  template <class Install>
  std::unique_ptr<RunningProgram> roll_back(const Verdict& verdict, Time now,
                                            const DeviceHealth& health, Install& install) noexcept {
    auto replaced = std::exchange(running_, predecessor(verdict.fault));
    probation_.end();
    if (last_good_) begin_probation(now, health);
    install(Handover{Event::Kind::kRolledBack, replaced.get(), verdict});
    return replaced;
  }

  [[nodiscard]] Verdict pending_fault() noexcept;
  [[nodiscard]] std::unique_ptr<RunningProgram> predecessor(Fault fault) noexcept;
  [[nodiscard]] std::unique_ptr<RunningProgram> keep(std::unique_ptr<RunningProgram> replaced,
                                                     bool proven) noexcept;
  void begin_probation(Time now, const DeviceHealth& health) noexcept;
  void retire(std::unique_ptr<RunningProgram> program) noexcept {
    intake_.retire(std::move(program));
  }

  ProgramIntake& intake_;
  std::unique_ptr<RunningProgram> running_;
  std::unique_ptr<RunningProgram> unproven_;   ///< the program that `running_` replaced while that
                                               ///< one was in probation
  std::unique_ptr<RunningProgram> last_good_;  ///< the last program before both that proved itself
  Probation probation_;
};

}  // namespace galilean::robot
