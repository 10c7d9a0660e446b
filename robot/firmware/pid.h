// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::robot::firmware {

struct PidGains {
  float proportional = 0;  ///< output per unit of error
  float integral = 0;      ///< output per unit of error and second
  float derivative = 0;    ///< output per unit of measured change a second
};

/// The measured value of the controlled quantity.
struct Measured {
  float value = 0;
  float change_s = 0;  ///< of the value a second
};

/// Textbook PID:  u = Kp·e + Ki·∫e dt − Kd·dm/dt,  e = wanted − measured m, clamped to ±limit.
/// The derivative acts on the measured value, so that a new target causes no jump. The integral is
/// held while the output is at its limit and the error would drive it further.
class Pid {
 public:
  void set(const PidGains& gains, float output_limit);
  /// Forgets the integral.
  void reset();
  /// Advances the loop by `dt_s` seconds. Returns its output.
  float step(float wanted, const Measured& measured, float dt_s);

 private:
  PidGains gains_;
  float limit_ = 0;
  float integral_ = 0;
};

}  // namespace galilean::robot::firmware
