// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/world/physics.h"

namespace galilean::sim {

enum class Phase { kWaiting, kRunning, kPaused, kOver };
[[nodiscard]] const char* to_string(Phase phase) noexcept;

/// The counts of one robot on the score sheet.
struct RobotTally {
  unsigned deposited = 0;
  unsigned collisions = 0;
};

/// An event that the referee counted.
struct RefereeCall {
  enum class What { kDeposited, kCollision };
  double elapsed_s = 0;
  std::size_t robot = 0;
  What what = What::kDeposited;
  double points = 0;  ///< earned; negative for a penalty
};
[[nodiscard]] const char* to_string(RefereeCall::What what) noexcept;

/// Keeps the clock and the score by the scenario's rules. It knows only what its methods are told.
///   score = points · deposited - penalty · collisions
class Referee {
 public:
  Referee(const Rules& rules, std::size_t robots);

  /// Starts the clock of a contest that waits, or lets it go on if it is paused.
  void start() noexcept;
  /// Stops the clock of a running contest. Nothing counts until `start`.
  void pause() noexcept;
  /// Clears the clock and the sheet. The contest waits for its start again.
  void reset() { *this = Referee(rules_, tallies_.size()); }
  void advance(double dt_s) noexcept;
  /// Takes a touch that began. It counts as a collision if it is hard enough, the other body is no
  /// piece, and the same two did not just collide.
  void record_collision(const Hit& hit);
  /// Takes the release of a piece at a distance from the nearest basket. Returns whether the piece
  /// is thrown away.
  [[nodiscard]] bool record_release(std::size_t robot, double to_basket_m);

  [[nodiscard]] Phase phase() const noexcept { return phase_; }
  [[nodiscard]] double elapsed_s() const noexcept { return elapsed_s_; }
  [[nodiscard]] double remaining_s() const noexcept { return rules_.duration_s - elapsed_s_; }
  [[nodiscard]] const std::vector<RobotTally>& robots() const noexcept { return tallies_; }
  /// Returns the newest calls, the oldest of them first.
  [[nodiscard]] const std::deque<RefereeCall>& calls() const noexcept { return calls_; }
  [[nodiscard]] const Rules& rules() const noexcept { return rules_; }
  [[nodiscard]] unsigned deposited() const noexcept;
  [[nodiscard]] unsigned collisions() const noexcept;
  [[nodiscard]] double score() const noexcept;

 private:
  static constexpr std::size_t kCallsKept = 64;

  void call(std::size_t robot, RefereeCall::What what, double points);

  Rules rules_;
  Phase phase_ = Phase::kWaiting;
  double elapsed_s_ = 0;
  std::vector<RobotTally> tallies_;
  std::deque<RefereeCall> calls_;
  std::map<std::pair<std::uint16_t, std::uint32_t>, double> last_hit_s_;
};

}  // namespace galilean::sim
