// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/random.h"
#include "sim/scenario/scenario.h"

namespace galilean::sim {

/// A robot's velocity in its own directions.
struct BodyVelocity {
  double forward_mps = 0;
  double left_mps = 0;
  double turn_radps = 0;
};

/// Two DC motors, their treads, and the floor under them. The model reads the PWM of both motors
/// and the body's velocity. It gives the body's new velocity and the encoders' counts. A motor
/// pulls with K (v_free - v). |PWM| below the dead zone gives no pull. The dead zone grows with
/// scrubbing, from a straight run (190 of 1000) to a turn in place (315):
///   v_free = sign(PWM) · max(0, |PWM| - dead) / (1000 - dead) · top speed.
/// Tread and floor exchange the impulse that makes them equally fast, but no more than friction
/// allows. The floor feels each tread slightly longer or shorter than its encoder counts, by a
/// fixed share and a varying one, so that dead reckoning drifts. The dead zones lie a little below
/// the paper's (200 and 330). The constants of motor and friction are our choice.
class Treads {
 public:
  static constexpr double kMass_kg = 4.5;  // the paper: ten pounds
  static constexpr double kTurnRadius_m = 0.185;
  static constexpr double kInertia_kgm2 = 0.11;
  static constexpr double kCountsPerMetre = 16 * 325.0;

  Treads(const Slip& slip, Random random);

  void set_pwm(int left, int right) noexcept;
  [[nodiscard]] BodyVelocity step(const BodyVelocity& body, double dt_s) noexcept;

  [[nodiscard]] std::int32_t left_counts() const noexcept { return left_.counts(); }
  [[nodiscard]] std::int32_t right_counts() const noexcept { return right_.counts(); }

 private:
  struct Tread {
    double pwm = 0;
    double speed_mps = 0;
    double travel_m = 0;
    double scale = 1;  ///< metres of floor a metre of tread
    double slip = 0;   ///< share of the travel gained or lost at present

    [[nodiscard]] std::int32_t counts() const noexcept;
    [[nodiscard]] double grip() const noexcept { return scale * (1 + slip); }
  };

  [[nodiscard]] double scrub() const noexcept;
  void run_motor(Tread& tread, double dt_s) noexcept;
  void vary_slip(double dt_s) noexcept;

  Slip slip_;
  Random random_;
  Tread left_;
  Tread right_;
  double turn_radius_m_ = kTurnRadius_m;
};

}  // namespace galilean::sim
