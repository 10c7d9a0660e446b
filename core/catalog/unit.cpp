// SPDX-License-Identifier: BSD-3-Clause
#include "core/catalog/unit.h"

#include <array>

namespace galilean {
namespace {

constexpr std::array kUnits{unit::kNone,
                            unit::kMetre,
                            unit::kCentimetre,
                            unit::kMillimetre,
                            unit::kInch,
                            unit::kFoot,
                            unit::kDegree,
                            unit::kRadian,
                            unit::kSecond,
                            unit::kMillisecond,
                            unit::kMinute,
                            unit::kMetrePerSecond,
                            unit::kCentimetrePerSecond,
                            unit::kMillimetrePerSecond,
                            unit::kDegreePerSecond,
                            unit::kRadianPerSecond,
                            unit::kPixel,
                            unit::kSquarePixel,
                            unit::kTick,
                            unit::kTickPerSecond,
                            unit::kTickPerSecondSquared,
                            unit::kTickPerCentimetre,
                            unit::kPwm,
                            unit::kPerSecond,
                            unit::kHertz};

}  // namespace

std::span<const Unit> all_units() noexcept {
  return kUnits;
}

std::optional<Unit> find_unit(std::string_view symbol) noexcept {
  for (const Unit& candidate : kUnits)
    if (candidate.symbol == symbol) return candidate;
  return std::nullopt;
}

}  // namespace galilean
