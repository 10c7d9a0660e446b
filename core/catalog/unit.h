// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace galilean {

/// A unit as BHDL writes it. Two units fit together if their dimensions are the same.
struct Unit {
  std::string_view symbol;     ///< "cm"
  std::string_view dimension;  ///< "length"
  double to_si;                ///< factor to SI, or to the dimension's own base unit
};

namespace unit {
inline constexpr Unit kNone{"", "number", 1};
inline constexpr Unit kMetre{"m", "length", 1};
inline constexpr Unit kCentimetre{"cm", "length", 0.01};
inline constexpr Unit kMillimetre{"mm", "length", 0.001};
inline constexpr Unit kInch{"in", "length", 0.0254};
inline constexpr Unit kFoot{"ft", "length", 0.3048};
inline constexpr Unit kDegree{"deg", "angle", 3.14159265358979323846 / 180};
inline constexpr Unit kRadian{"rad", "angle", 1};
inline constexpr Unit kSecond{"s", "time", 1};
inline constexpr Unit kMillisecond{"ms", "time", 0.001};
inline constexpr Unit kMinute{"min", "time", 60};
inline constexpr Unit kMetrePerSecond{"m/s", "speed", 1};
inline constexpr Unit kCentimetrePerSecond{"cm/s", "speed", 0.01};
inline constexpr Unit kMillimetrePerSecond{"mm/s", "speed", 0.001};
inline constexpr Unit kDegreePerSecond{"deg/s", "angular speed", 3.14159265358979323846 / 180};
inline constexpr Unit kRadianPerSecond{"rad/s", "angular speed", 1};
inline constexpr Unit kPixel{"px", "pixels", 1};
inline constexpr Unit kSquarePixel{"px^2", "pixel area", 1};
inline constexpr Unit kTick{"ticks", "encoder ticks", 1};
inline constexpr Unit kTickPerSecond{"ticks/s", "encoder speed", 1};
inline constexpr Unit kTickPerSecondSquared{"ticks/s^2", "encoder acceleration", 1};
inline constexpr Unit kTickPerCentimetre{"ticks/cm", "encoder resolution", 100};
inline constexpr Unit kPwm{"pwm", "motor power", 1};
inline constexpr Unit kPerSecond{"1/s", "rate", 1};
inline constexpr Unit kHertz{"Hz", "rate", 1};
}  // namespace unit

[[nodiscard]] std::span<const Unit> all_units() noexcept;
[[nodiscard]] std::optional<Unit> find_unit(std::string_view symbol) noexcept;

}  // namespace galilean
