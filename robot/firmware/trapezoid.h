// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::robot::firmware {

/// Trapezoidal velocity profile of one wheel: ramps with a constant acceleration to the wanted
/// speed, holds it, and ramps down so that it stands at the travel limit.
///
/// Law, for a step of dt with s the travel that is left and a the acceleration: the speed follows
/// the target by at most a·dt, and is never above the v that can still stop in time,
///   v²/2a + (v + v_now)·dt/2 = s.
/// Units are the caller's, as long as they agree (here counts, counts/s, counts/s²).
class Trapezoid {
 public:
  /// Starts a motion from the present speed. `travel_limit` is measured from here in the direction
  /// of `speed`; 0 means no limit. If the limit is shorter than the braking distance, the wheel
  /// stops behind it.
  void aim(float speed, float acceleration, float travel_limit);
  /// Sets the speed from which the next motion ramps.
  void start_from(float speed) { speed_ = speed; }
  /// Stops at once, without a ramp, and forgets the motion.
  void cut();
  /// Returns the speed after the next `dt_s` seconds.
  float step(float dt_s);

  float speed() const { return speed_; }
  /// Returns whether the wheel stands, and will until the next `aim`.
  bool resting() const { return speed_ == 0 && target_ == 0; }

 private:
  float fastest_that_stops_in_time(float dt_s) const;
  void count_down(float travel);

  float speed_ = 0;
  float target_ = 0;
  float acceleration_ = 1;
  bool limited_ = false;
  float direction_ = 1;
  double travel_left_ = 0;  // a float would lose slow steps from a long way
};

}  // namespace galilean::robot::firmware
