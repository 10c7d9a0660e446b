// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/treads.h"

#include <algorithm>
#include <cmath>

#include "sim/world/physics.h"

namespace galilean::sim {
namespace {

constexpr double kFullPwm = 1000;
constexpr double kStraightDeadZone_pwm = 190;
constexpr double kTurnDeadZone_pwm = 315;
constexpr double kTopSpeed_mps = 0.6;
constexpr double kStall_n = 12;        // of a tread at full power; the floor's friction is higher
constexpr double kTreadMass_kg = 0.6;  // as the floor feels it, with rotor and gears
constexpr double kFriction = 0.7;      // rubber on carpet
constexpr double kSlipTimeConstant_s = 1;  // time constant with which the slip changes
/// Dry friction and the floor act on a tread in turns, until both are content. Fewer rounds let a
/// body drag treads that should hold it.
constexpr int kRounds = 4;

/// Both treads and the body as one motion sees them: the body's `mass_kg` is its inertia there.
struct Contact {
  double mass_kg = 0;
  double most_ns = 0;   ///< what friction allows in a step
  double given_ns = 0;  ///< what the body was given in this step

  /// Returns the impulse [Ns] that equalises the speeds, as far as friction allows.
  double equalise(double tread_mps, double body_mps) {
    const double both_treads_kg = 2 * kTreadMass_kg;
    const double shared_kg = both_treads_kg * mass_kg / (both_treads_kg + mass_kg);
    const double wanted_ns = given_ns + (tread_mps - body_mps) * shared_kg;
    const double before_ns = given_ns;
    given_ns = std::clamp(wanted_ns, -most_ns, most_ns);
    return given_ns - before_ns;
  }
};

double without_rubbing(double speed_mps, double& rubbing_mps) {
  const double taken_mps = std::clamp(speed_mps, -rubbing_mps, rubbing_mps);
  rubbing_mps -= std::abs(taken_mps);
  return speed_mps - taken_mps;
}

}  // namespace

std::int32_t Treads::Tread::counts() const noexcept {
  return static_cast<std::int32_t>(std::floor(travel_m * kCountsPerMetre));
}

Treads::Treads(const Slip& slip, Random random) : slip_(slip), random_(random) {
  const double both = slip.scale_error * random_.normal();
  const double apart = slip.mismatch * random_.normal() / 2;
  left_.scale = 1 + both - apart;
  right_.scale = 1 + both + apart;
  turn_radius_m_ = kTurnRadius_m * (1 + slip.turn_error * random_.normal());
}

void Treads::set_pwm(int left, int right) noexcept {
  left_.pwm = std::clamp<double>(left, -kFullPwm, kFullPwm);
  right_.pwm = std::clamp<double>(right, -kFullPwm, kFullPwm);
}

double Treads::scrub() const noexcept {
  const double sum = std::abs(left_.pwm) + std::abs(right_.pwm);
  return sum > 0 ? std::abs(left_.pwm - right_.pwm) / sum : 0;
}

double Treads::dead_zone_pwm() const noexcept {
  return kStraightDeadZone_pwm + scrub() * (kTurnDeadZone_pwm - kStraightDeadZone_pwm);
}

void Treads::run_motor(Tread& tread, double dt_s) noexcept {
  const double dead = dead_zone_pwm() / kFullPwm;
  const double slope_ns_m = kStall_n * (1 - dead) / kTopSpeed_mps;
  const double full_mps = dt_s * kStall_n / kTreadMass_kg;  // what the stall force gives in a step
  // The step is implicit, because the motor settles in little more than one step.
  const double slower = 1 + dt_s * slope_ns_m / kTreadMass_kg;
  tread.speed_mps = (tread.speed_mps + full_mps * tread.pwm / kFullPwm) / slower;
  tread.rubbing_mps = full_mps * dead / slower;
}

void Treads::vary_slip(double dt_s) noexcept {
  const double share =
      slip_.straight_noise + scrub() * (slip_.turning_noise - slip_.straight_noise);
  const double keep = 1 - dt_s / kSlipTimeConstant_s;
  const double kick = share * std::sqrt(1 - keep * keep);
  left_.slip = keep * left_.slip + kick * random_.normal();
  right_.slip = keep * right_.slip + kick * random_.normal();
}

BodyVelocity Treads::step(const BodyVelocity& body, double dt_s) noexcept {
  run_motor(left_, dt_s);
  run_motor(right_, dt_s);
  vary_slip(dt_s);

  const double most_ns = kFriction * kMass_kg * kGravity_mps2 * dt_s;
  const double turning_kg = kInertia_kgm2 / (turn_radius_m_ * turn_radius_m_);

  Contact straight{kMass_kg, most_ns};
  Contact turning{turning_kg, most_ns};
  for (int round = 0; round < kRounds; ++round) {
    left_.speed_mps = without_rubbing(left_.speed_mps, left_.rubbing_mps);
    right_.speed_mps = without_rubbing(right_.speed_mps, right_.rubbing_mps);
    const double left_mps = left_.speed_mps * left_.grip();
    const double right_mps = right_.speed_mps * right_.grip();
    const double push_ns = straight.equalise((left_mps + right_mps) / 2,
                                             body.forward_mps + straight.given_ns / kMass_kg);
    const double twist_ns =
        turning.equalise((right_mps - left_mps) / 2,
                         body.turn_radps * turn_radius_m_ + turning.given_ns / turning_kg);
    left_.speed_mps -= (push_ns - twist_ns) / (2 * kTreadMass_kg);
    right_.speed_mps -= (push_ns + twist_ns) / (2 * kTreadMass_kg);
  }
  left_.travel_m += left_.speed_mps * dt_s;
  right_.travel_m += right_.speed_mps * dt_s;

  BodyVelocity after;
  after.forward_mps = body.forward_mps + straight.given_ns / kMass_kg;
  after.left_mps =
      body.left_mps - std::clamp(body.left_mps, -most_ns / kMass_kg, most_ns / kMass_kg);
  after.turn_radps = body.turn_radps + turning.given_ns / turning_kg / turn_radius_m_;
  return after;
}

}  // namespace galilean::sim
