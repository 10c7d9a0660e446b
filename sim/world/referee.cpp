// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/referee.h"

namespace galilean::sim {

const char* to_string(Phase phase) noexcept {
  switch (phase) {
    case Phase::kWaiting:
      return "waiting";
    case Phase::kRunning:
      return "running";
    case Phase::kPaused:
      return "paused";
    case Phase::kOver:
      break;
  }
  return "over";
}

const char* to_string(RefereeCall::What what) noexcept {
  return what == RefereeCall::What::kDeposited ? "deposited" : "collision";
}

Referee::Referee(const Rules& rules, std::size_t robots) : rules_(rules), tallies_(robots) {}

void Referee::start() noexcept {
  if (phase_ == Phase::kWaiting || phase_ == Phase::kPaused) phase_ = Phase::kRunning;
}

void Referee::pause() noexcept {
  if (phase_ == Phase::kRunning) phase_ = Phase::kPaused;
}

void Referee::advance(double dt_s) noexcept {
  if (phase_ != Phase::kRunning) return;
  elapsed_s_ += dt_s;
  if (elapsed_s_ < rules_.duration_s) return;
  elapsed_s_ = rules_.duration_s;
  phase_ = Phase::kOver;
}

void Referee::record_collision(const Hit& hit) {
  const bool counts = phase_ == Phase::kRunning && hit.other.kind != BodyKind::kPiece &&
                      hit.approach_mps >= rules_.collision_speed_mps;
  if (!counts) return;
  const auto [last, first] = last_hit_s_.try_emplace({hit.robot, hit.other.packed()}, elapsed_s_);
  const bool again = first || elapsed_s_ - last->second >= rules_.collision_pause_s;
  last->second = elapsed_s_;
  if (!again) return;
  ++tallies_[hit.robot].collisions;
  call(hit.robot, RefereeCall::What::kCollision, -rules_.penalty_per_collision);
}

bool Referee::record_release(std::size_t robot, double to_basket_m) {
  if (phase_ != Phase::kRunning || to_basket_m > rules_.basket_zone_m) return false;
  ++tallies_[robot].deposited;
  call(robot, RefereeCall::What::kDeposited, rules_.points_per_piece);
  return true;
}

void Referee::call(std::size_t robot, RefereeCall::What what, double points) {
  calls_.push_back({elapsed_s_, robot, what, points});
  if (calls_.size() > kCallsKept) calls_.pop_front();
}

unsigned Referee::deposited() const noexcept {
  unsigned sum = 0;
  for (const auto& tally : tallies_) sum += tally.deposited;
  return sum;
}

unsigned Referee::collisions() const noexcept {
  unsigned sum = 0;
  for (const auto& tally : tallies_) sum += tally.collisions;
  return sum;
}

double Referee::score() const noexcept {
  return rules_.points_per_piece * deposited() - rules_.penalty_per_collision * collisions();
}

}  // namespace galilean::sim
