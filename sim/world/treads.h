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
/// and the body's velocity. It gives the body's new velocity and the encoders' counts.
///
/// A motor is the field's linear one: it pulls with stall · PWM / 1000 - K v. The term K v is the
/// back-EMF's. It brakes also at PWM 0, which shorts the motor. The dry friction of gear and tread,
/// stall · dead / 1000, opposes any motion. It is what makes a dead zone, and it brakes as much as
/// it hinders. K is the one with which full PWM gives the top speed. The steady speed is therefore
///   v = sign(PWM) · max(0, |PWM| - dead) / (1000 - dead) · top speed.
/// The dead zone grows with scrubbing, from a straight run (190 of 1000) to a turn in place (315).
/// At full speed (30.8 cm/s) a short stops a straight run in 0.2 s and 2.6 cm, and full power
/// backwards in 0.06 s and 1 cm. The latter is what the floor's friction just allows.
///
/// Tread and floor exchange the impulse that makes them equally fast, but no more than friction
/// allows. The floor feels each tread slightly longer or shorter than its encoder counts, by a
/// fixed share and a varying one, so that dead reckoning drifts.
///
/// Sources: the mass is the paper's, and the full speed follows from its listing. The dead zones
/// lie a little below those of the listing (200 and 330). Stall force, top speed, tread mass and
/// the coefficient of friction were published nowhere and are our choice: the stall force of a
/// tread is about a quarter of the robot's weight, and the top speed twice the full speed.
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
    double scale = 1;        ///< metres of floor a metre of tread
    double slip = 0;         ///< share of the travel gained or lost at present
    double rubbing_mps = 0;  ///< of its speed that dry friction may still take in this step

    [[nodiscard]] std::int32_t counts() const noexcept;
    [[nodiscard]] double grip() const noexcept { return scale * (1 + slip); }
  };

  [[nodiscard]] double scrub() const noexcept;
  [[nodiscard]] double dead_zone_pwm() const noexcept;
  void run_motor(Tread& tread, double dt_s) noexcept;
  void vary_slip(double dt_s) noexcept;

  Slip slip_;
  Random random_;
  Tread left_;
  Tread right_;
  double turn_radius_m_ = kTurnRadius_m;
};

}  // namespace galilean::sim
