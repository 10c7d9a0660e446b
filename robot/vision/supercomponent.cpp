// SPDX-License-Identifier: BSD-3-Clause
#include "robot/vision/supercomponent.h"

#include <algorithm>
#include <array>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "robot/vision/supercomponent.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace galilean::robot {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Returns the bytes times the gain, at most 255. Even and odd bytes are multiplied separately,
/// each in the upper half of a 16-bit lane.
template <class D, class V>
HWY_INLINE V amplified(D d, V bytes, Gain gain) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(d, static_cast<std::uint8_t>(std::min(255, hn::GetLane(bytes) * gain >> 8)));
#else
  const hn::Repartition<std::uint16_t, D> wide;
  const auto factor = hn::Set(wide, gain);
  const auto limit = hn::Set(wide, static_cast<std::uint16_t>(255));
  const auto upper = hn::Set(wide, static_cast<std::uint16_t>(0xFF00));
  const auto even = hn::ShiftLeft<8>(hn::BitCast(wide, bytes));
  const auto odd = hn::And(hn::BitCast(wide, bytes), upper);
  const auto low = hn::Min(hn::MulHigh(even, factor), limit);
  const auto high = hn::Min(hn::MulHigh(odd, factor), limit);
  return hn::BitCast(d, hn::Or(low, hn::ShiftLeft<8>(high)));
#endif
}

template <class D>
HWY_INLINE void split_lanes(D d, const std::uint8_t* rgb, std::size_t at, Gain gain,
                            const ComponentPlanes& planes) {
  hn::Vec<D> red, green, blue;
  hn::LoadInterleaved3(d, rgb + 3 * at, red, green, blue);
  const auto store = [&](std::uint8_t* plane, hn::Vec<D> bytes) HWY_ATTR {
    if (plane) hn::StoreU(gain == kUnityGain ? bytes : amplified(d, bytes, gain), d, plane + at);
  };
  store(planes.superred, hn::SaturatedSub(red, hn::SaturatedAdd(green, blue)));
  store(planes.supergreen, hn::SaturatedSub(green, hn::SaturatedAdd(red, blue)));
  store(planes.superblue, hn::SaturatedSub(blue, hn::SaturatedAdd(red, green)));
  store(planes.intensity, hn::AverageRound(hn::AverageRound(red, blue), green));
}

void split(const std::uint8_t* HWY_RESTRICT rgb, std::size_t pixels, Gain gain,
           const ComponentPlanes& planes) {
  const hn::ScalableTag<std::uint8_t> d;
  std::size_t at = 0;
  for (; at + hn::Lanes(d) <= pixels; at += hn::Lanes(d)) split_lanes(d, rgb, at, gain, planes);
  if (at < pixels) split_lanes(d, rgb, pixels - hn::Lanes(d), gain, planes);
}

}  // namespace HWY_NAMESPACE
}  // namespace galilean::robot
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace galilean::robot {

HWY_EXPORT(split);

Gain normalising_gain(std::span<const std::uint8_t> rgb, int width_px) noexcept {
  constexpr std::size_t kStep = 8;
  constexpr int kWhite = 240;
  std::array<std::uint32_t, 256> histogram{};
  std::uint32_t samples = 0;
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(width_px);
  for (std::size_t row = 0; row + row_bytes <= rgb.size(); row += kStep * row_bytes)
    for (std::size_t at = row; at + 2 < row + row_bytes; at += 3 * kStep) {
      ++histogram[std::max({rgb[at], rgb[at + 1], rgb[at + 2]})];
      ++samples;
    }
  int white = 255;
  for (std::uint32_t brighter = histogram[255]; white > 1 && brighter * 50 < samples; --white)
    brighter += histogram[static_cast<std::size_t>(white) - 1];
  return static_cast<Gain>(std::clamp(kWhite * kUnityGain / white, 1 * kUnityGain, 2 * kUnityGain));
}

void split_components(std::span<const std::uint8_t> rgb, Gain gain,
                      const ComponentPlanes& planes) noexcept {
  HWY_DYNAMIC_DISPATCH(split)(rgb.data(), rgb.size() / 3, gain, planes);
}

}  // namespace galilean::robot
#endif
