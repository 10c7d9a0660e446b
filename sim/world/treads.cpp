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
constexpr double kStall_n = 12;        // of a tread at full power; friction is higher: it stalls
constexpr double kTreadMass_kg = 0.6;  // as the floor feels it, with rotor and gears
constexpr double kFriction = 0.7;      // rubber on carpet
constexpr double kSlipTimeConstant_s = 1;  // time constant with which the slip changes

/// Returns the impulse [Ns] that equalises the speeds of two masses, as far as friction allows.
double coupling(double tread_mps, double body_mps, double body_kg, double most_ns) {
  const double both_treads_kg = 2 * kTreadMass_kg;
  const double shared_kg = both_treads_kg * body_kg / (both_treads_kg + body_kg);
  return std::clamp((tread_mps - body_mps) * shared_kg, -most_ns, most_ns);
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

void Treads::run_motor(Tread& tread, double dt_s) noexcept {
  const double dead = kStraightDeadZone_pwm + scrub() * (kTurnDeadZone_pwm - kStraightDeadZone_pwm);
  const double share = std::max(0.0, std::abs(tread.pwm) - dead) / (kFullPwm - dead);
  const double free_mps = std::copysign(share * kTopSpeed_mps, tread.pwm);
  // The step is implicit, because the motor settles in little more than one step.
  const double rate = dt_s * kStall_n / kTopSpeed_mps / kTreadMass_kg;
  tread.speed_mps = (tread.speed_mps + rate * free_mps) / (1 + rate);
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

  const double left_mps = left_.speed_mps * left_.grip();
  const double right_mps = right_.speed_mps * right_.grip();
  const double most_ns = kFriction * kMass_kg * kGravity_mps2 * dt_s;
  const double turning_kg = kInertia_kgm2 / (turn_radius_m_ * turn_radius_m_);

  const double push_ns = coupling((left_mps + right_mps) / 2, body.forward_mps, kMass_kg, most_ns);
  const double twist_ns =
      coupling((right_mps - left_mps) / 2, body.turn_radps * turn_radius_m_, turning_kg, most_ns);
  left_.speed_mps -= (push_ns - twist_ns) / (2 * kTreadMass_kg);
  right_.speed_mps -= (push_ns + twist_ns) / (2 * kTreadMass_kg);
  left_.travel_m += left_.speed_mps * dt_s;
  right_.travel_m += right_.speed_mps * dt_s;

  BodyVelocity after;
  after.forward_mps = body.forward_mps + push_ns / kMass_kg;
  after.left_mps =
      body.left_mps - std::clamp(body.left_mps, -most_ns / kMass_kg, most_ns / kMass_kg);
  after.turn_radps = body.turn_radps + twist_ns / turning_kg / turn_radius_m_;
  return after;
}

}  // namespace galilean::sim
