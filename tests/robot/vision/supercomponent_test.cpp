// SPDX-License-Identifier: BSD-3-Clause
#include "robot/vision/supercomponent.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <algorithm>
#include <vector>

#include "core/random.h"

namespace galilean::robot {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Planes {
  explicit Planes(std::size_t pixels)
      : red(pixels), green(pixels), blue(pixels), intensity(pixels) {}
  Bytes red, green, blue, intensity;
  bool operator==(const Planes&) const = default;
};

Bytes random_picture(std::size_t pixels) {
  Random random(1);
  Bytes rgb(pixels * 3);
  for (auto& byte : rgb) byte = static_cast<std::uint8_t>(random.below(256));
  return rgb;
}

/// The definition, pixel by pixel.
Planes by_definition(const Bytes& rgb, Gain gain) {
  Planes planes(rgb.size() / 3);
  const auto amplified = [gain](int x) {
    return static_cast<std::uint8_t>(std::min(255, std::max(0, x) * gain / 256));
  };
  for (std::size_t i = 0; i < planes.red.size(); ++i) {
    const int r = rgb[3 * i], g = rgb[3 * i + 1], b = rgb[3 * i + 2];
    planes.red[i] = amplified(r - (g + b));
    planes.green[i] = amplified(g - (r + b));
    planes.blue[i] = amplified(b - (r + g));
    planes.intensity[i] = amplified(((r + b + 1) / 2 + g + 1) / 2);
  }
  return planes;
}

Planes split(const Bytes& rgb, Gain gain) {
  Planes planes(rgb.size() / 3);
  split_components(
      rgb, gain,
      {planes.red.data(), planes.green.data(), planes.blue.data(), planes.intensity.data()});
  return planes;
}

TEST(Supercomponent, EqualsItsDefinitionOnEveryInstructionSetOfThisMachine) {
  const Bytes rgb = random_picture(1000);  // no multiple of any vector's length
  for (const Gain gain : {kUnityGain, Gain{300}, Gain{512}})
    for (const auto target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      EXPECT_TRUE(split(rgb, gain) == by_definition(rgb, gain))
          << hwy::TargetName(target) << ", gain " << gain;
    }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(Supercomponent, WhiteIsNoColourAndPlanesMayBeLeftOut) {
  const Bytes white(3 * 256, 250);
  Bytes red(256, 99), intensity(256);
  split_components(white, kUnityGain, {.superred = red.data(), .intensity = intensity.data()});
  EXPECT_EQ(red[7], 0);
  EXPECT_EQ(intensity[7], 250);
}

TEST(NormalisingGain, BringsADimPictureToFullBrightnessButNoMoreThanTwice) {
  const auto gain_of = [](std::uint8_t level) {
    return normalising_gain(Bytes(352 * 186 * 3, level), 352);
  };
  EXPECT_EQ(gain_of(255), kUnityGain);
  EXPECT_EQ(gain_of(240), kUnityGain);
  EXPECT_EQ(gain_of(160), kUnityGain * 3 / 2);
  EXPECT_EQ(gain_of(60), kUnityGain * 2);
  EXPECT_EQ(gain_of(0), kUnityGain * 2);
}

TEST(NormalisingGain, IsNotFooledByASingleGlareSpot) {
  Bytes rgb(352 * 186 * 3, 160);
  std::fill_n(rgb.begin() + 352 * 3 * 80, 30, 255);
  EXPECT_EQ(normalising_gain(rgb, 352), kUnityGain * 3 / 2);
}

}  // namespace
}  // namespace galilean::robot
