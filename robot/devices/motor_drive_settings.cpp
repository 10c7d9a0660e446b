// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/motor_drive_settings.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "core/device/device_names.h"

namespace galilean::robot {
namespace {

using S = MotorDriveSettings;

/// Takes the dead zones in the order in which the paper prints them. The position decides the sign,
/// so that a forgotten minus does no harm.
firmware::DeadZones dead_zones(const std::vector<double>& pwm) {
  const auto size = [&pwm](std::size_t i) {
    return static_cast<std::int16_t>(i < pwm.size() ? std::lround(std::fabs(pwm[i])) : 0);
  };
  const auto reverse = [&size](std::size_t i) { return static_cast<std::int16_t>(-size(i)); };
  return {size(0), size(1), reverse(2), reverse(3)};
}

void describe_motion(Declaration<S>& is) {
  is.number(&S::forward_velocity_ticks_s, "forward_velocity", unit::kTickPerSecond, 100,
            "speed of the wheels straight ahead")
      .range(1, 2000);
  is.number(&S::turning_velocity_ticks_s, "turning_velocity", unit::kTickPerSecond, 100,
            "speed of the wheels in a turn on the spot")
      .range(1, 2000);
  is.number(&S::acceleration_ticks_s2, "acceleration", unit::kTickPerSecondSquared, 300,
            "slope of the velocity profile; 10 takes ten seconds to get to 100 ticks/s")
      .range(1, 100000);
  is.number(&S::timeout_s, "timeout", unit::kSecond, 0.5,
            "how long a command lasts: the motors stop when no schema drove for so long")
      .range(0.02, 120);
}

void describe_motors(Declaration<S>& is) {
  constexpr auto order = "left forward, right forward, left reverse, right reverse";
  is.numbers(&S::straight_dead_zones_pwm, "straight_dead_zones", unit::kPwm, {200, 200, -200, -200},
             std::string("power (of 1000) below which a motor stands, going straight: ") + order)
      .alias("stright_dead_zones")
      .count(4)
      .range(-1000, 1000);
  is.numbers(&S::turn_dead_zones_pwm, "turn_dead_zones", unit::kPwm, {330, 330, -330, -330},
             std::string("the same on the spot, where the treads scrub: ") + order)
      .count(4)
      .range(-1000, 1000);
  is.number(&S::proportional_gain, "proportional_gain", unit::kNone, 8,
            "power per tick/s of speed error")
      .range(0, 1000);
  is.number(&S::integral_gain, "integral_gain", unit::kNone, 80,
            "power per tick of summed speed error")
      .range(0, 10000);
  is.number(&S::derivative_gain, "derivative_gain", unit::kNone, 0,
            "power per tick/s^2 of acceleration, against it")
      .range(0, 1000);
  is.number(&S::feedforward_gain, "feedforward_gain", unit::kNone, 3.5,
            "power per tick/s of wanted speed, beyond the dead zone")
      .range(0, 1000);
}

void describe_geometry(Declaration<S>& is) {
  is.number(&S::turn_radius_m, "turn_radius", unit::kCentimetre, 18.5,
            "half the track: what a wheel travels in a turn of one radian on the spot")
      .range(1, 1000);
  is.number(&S::ticks_per_m, "cms_constant", unit::kTickPerCentimetre, 3.25,
            "encoder ticks in a centimetre of travel")
      .range(0.01, 1000);
}

}  // namespace

void MotorDriveSettings::describe(Declaration<MotorDriveSettings>& is) {
  is.help("Steering and translation by two motors.");
  is.configures(kMotorDriveName);
  describe_motion(is);
  describe_motors(is);
  describe_geometry(is);
}

firmware::Parameters MotorDriveSettings::parameters() const noexcept {
  firmware::Parameters parameters;
  parameters.proportional_gain = static_cast<float>(proportional_gain);
  parameters.integral_gain = static_cast<float>(integral_gain);
  parameters.derivative_gain = static_cast<float>(derivative_gain);
  parameters.feedforward_gain = static_cast<float>(feedforward_gain);
  parameters.straight_dead_zones = dead_zones(straight_dead_zones_pwm);
  parameters.turn_dead_zones = dead_zones(turn_dead_zones_pwm);
  parameters.forward_velocity_ticks_s = static_cast<float>(forward_velocity_ticks_s);
  parameters.turning_velocity_ticks_s = static_cast<float>(turning_velocity_ticks_s);
  parameters.acceleration_ticks_s2 = static_cast<float>(acceleration_ticks_s2);
  parameters.timeout_ms = static_cast<std::uint32_t>(std::lround(timeout_s * 1000));
  return parameters;
}

}  // namespace galilean::robot
