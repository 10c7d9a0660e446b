// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::monitor {

/// How an object is drawn in three dimensions: its approximate size, and a colour that people who
/// are colour-blind tell from the others.
struct Appearance {
  double diameter_m;
  double height_m;
  float red, green, blue;
};

[[nodiscard]] inline Appearance appearance_of(const std::string& object_class) {
  if (object_class == "trash") return {0.07, 0.12, 0.90F, 0.62F, 0.00F};
  if (object_class == "basket") return {0.30, 0.35, 0.00F, 0.45F, 0.70F};
  return {0.16, 0.30, 0.45F, 0.45F, 0.45F};
}

/// A robot's chassis.
struct Body {
  static constexpr double kLength_m = 0.43, kWidth_m = 0.33, kHeight_m = 0.30;
  static constexpr float kRed = 0.00F, kGreen = 0.62F, kBlue = 0.45F;
  static constexpr float kSilentOpacity = 0.3F;
};

/// An object is as opaque as it is certain, but never less opaque than this.
inline constexpr float kLeastOpacity = 0.15F;
/// Half axes of the ellipse that contains a position with a probability of 95 %, in standard
/// deviations: the square root of the 95 % quantile of chi² with two degrees of freedom.
inline constexpr double kEllipseDeviations = 2.4477;

}  // namespace galilean::monitor
