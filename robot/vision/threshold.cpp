// SPDX-License-Identifier: BSD-3-Clause
#include "robot/vision/threshold.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "robot/vision/threshold.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace galilean::robot {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void make_mask(const std::uint8_t* HWY_RESTRICT pixels, std::size_t count, Threshold threshold,
               std::uint8_t* HWY_RESTRICT mask) {
  const bool dark = threshold.polarity == Polarity::kDark;
  std::size_t at = 0;
#if HWY_TARGET != HWY_SCALAR
  const hn::ScalableTag<std::uint8_t> d;
  const auto level = hn::Set(d, threshold.level);
  for (; at + hn::Lanes(d) <= count; at += hn::Lanes(d)) {
    const auto bytes = hn::LoadU(d, pixels + at);
    const auto bright = hn::Eq(hn::Max(bytes, level), bytes);
    hn::StoreMaskBits(d, dark ? hn::Not(bright) : bright, mask + at / 8);
  }
#endif
  for (; at < count; ++at) {
    if (at % 8 == 0) mask[at / 8] = 0;
    const bool stands_out = (pixels[at] >= threshold.level) != dark;
    mask[at / 8] = static_cast<std::uint8_t>(mask[at / 8] | (stands_out ? 1U << at % 8 : 0U));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace galilean::robot
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace galilean::robot {

HWY_EXPORT(make_mask);

void threshold_mask(std::span<const std::uint8_t> pixels, Threshold threshold,
                    std::uint8_t* mask) noexcept {
  HWY_DYNAMIC_DISPATCH(make_mask)(pixels.data(), pixels.size(), threshold, mask);
}

}  // namespace galilean::robot
#endif
