// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/geometry.h"
#include "core/static_vector.h"

namespace galilean {

/// The paper's two attributes that all variables share, and how the second fades:
/// certainty(t) = max(0, certainty - decay_per_s · (t - stamp)); a variable at 0 is invalid.
struct Reliability {
  bool valid = false;
  double certainty = 0;           ///< 0 (not reliable) .. 1, at `stamp`
  double decay_per_s = 1.0 / 60;  ///< the paper: nothing is left after a minute out of view
  Time stamp{};

  [[nodiscard]] double certainty_at(Time now) const noexcept;
  [[nodiscard]] bool valid_at(Time now) const noexcept { return valid && certainty_at(now) > 0; }
};

/// Position and heading by dead reckoning, in the robot's global frame ("odom").
struct Shaft {
  Pose2 pose;
  double speed_mps = 0;
  double turn_rate_radps = 0;
};

/// One 8-bit component of the newest frame, row-major from the top left. Its size is set once, when
/// the program is built.
struct Image {
  static constexpr int kWidth = 352;
  static constexpr int kHeight = 186;

  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(kWidth * kHeight);
  std::uint64_t frame = 0;  ///< number of the frame that it was made from; 0: none yet
  Time captured{};
};

enum class ObjectClass : std::uint8_t { kUnknown, kTrash, kBasket, kObstacle, kRobot };
[[nodiscard]] const char* to_string(ObjectClass object) noexcept;

/// One object as one frame showed it. Pixel bounds are inclusive.
struct Sighting {
  Vec2 position_m = Vec2::Zero();  ///< odom frame
  Mat2 covariance_m2 =
      Mat2::Zero();        ///< odom frame; grows with range as the camera's geometry says
  double range_m = 0;      ///< from the camera, along the floor
  double azimuth_rad = 0;  ///< counter-clockwise from straight ahead
  std::uint16_t left_px = 0, top_px = 0, right_px = 0, bottom_px = 0;
  std::uint32_t area_px = 0;
};

/// Where one object of the environment is, in the robot's global frame ("odom").
struct Locate {
  static constexpr std::size_t kMaxSightings = 16;

  ObjectClass object = ObjectClass::kUnknown;
  Vec2 position_m = Vec2::Zero();
  Mat2 covariance_m2 = Mat2::Identity();
  double radius_m = 0;
  /// All objects of this class in the newest frame, the nearest first. They are for viewers.
  /// Schemas do not read them.
  StaticVector<Sighting, kMaxSightings> sightings;
  std::uint64_t sightings_frame = 0;
};

/// Binary events, bit 0 first.
struct Bits {
  std::uint32_t value = 0;

  [[nodiscard]] bool test(unsigned index) const noexcept { return (value >> index) & 1U; }
  void assign(unsigned index, bool on) noexcept {
    value = on ? value | (1U << index) : value & ~(1U << index);
  }
};

/// The vector that a motor schema suggests, in the robot frame (x right, y forward). It has no
/// unit.
struct Force {
  Vec2 value = Vec2::Zero();
};

/// A public object that schemas share by name.
template <class T>
struct Variable {
  std::string name;
  T value{};
  Reliability reliability;
  std::uint64_t written_tick = 0;  ///< the tick in which a schema last wrote it; 0: none did
  bool constant = true;            ///< no schema of the program writes it

  void write(const T& new_value, double certainty, Time now, std::uint64_t tick) {
    value = new_value;
    mark_written(certainty, now, tick);
  }
  /// Notes that a schema has written into `value` in place.
  void mark_written(double certainty, Time now, std::uint64_t tick) noexcept {
    reliability.valid = true;
    reliability.certainty = certainty;
    reliability.stamp = now;
    written_tick = tick;
  }
  /// Returns the certainty at `now`. That of a constant does not decay, because no schema could
  /// write the constant again.
  [[nodiscard]] double certainty_at(Time now) const noexcept {
    if (constant) return reliability.valid ? reliability.certainty : 0;
    return reliability.certainty_at(now);
  }
  [[nodiscard]] bool valid_at(Time now) const noexcept { return certainty_at(now) > 0; }
  /// Makes the variable invalid, as the reset_variables of a condition asks.
  void reset(Time now) noexcept {
    reliability.valid = false;
    reliability.certainty = 0;
    reliability.stamp = now;
  }
};

}  // namespace galilean
