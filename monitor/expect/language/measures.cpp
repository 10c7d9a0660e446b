// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/measures.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace galilean::expect {
namespace {

using Of = MeasureSpec::Of;

constexpr std::array kMeasures{
    MeasureSpec{"x", Measure::kRobotX, unit::kMetre, Of::kRobot},
    MeasureSpec{"y", Measure::kRobotY, unit::kMetre, Of::kRobot},
    MeasureSpec{"heading", Measure::kRobotHeading, unit::kRadian, Of::kRobot},
    MeasureSpec{"tick time", Measure::kTickTime, unit::kSecond, Of::kRobot},
    MeasureSpec{"tick overruns", Measure::kTickOverruns, unit::kNone, Of::kRobot},
    MeasureSpec{"problems", Measure::kProblems, unit::kNone, Of::kRobot},
    MeasureSpec{"certainty", Measure::kCertainty, unit::kNone, Of::kVariable},
    MeasureSpec{"x", Measure::kVariableX, unit::kMetre, Of::kVariable},
    MeasureSpec{"y", Measure::kVariableY, unit::kMetre, Of::kVariable},
    MeasureSpec{"heading", Measure::kVariableHeading, unit::kRadian, Of::kVariable},
    MeasureSpec{"speed", Measure::kSpeed, unit::kMetrePerSecond, Of::kVariable},
    MeasureSpec{"turn rate", Measure::kTurnRate, unit::kRadianPerSecond, Of::kVariable},
    MeasureSpec{"radius", Measure::kRadius, unit::kMetre, Of::kVariable},
    MeasureSpec{"distance", Measure::kDistance, unit::kMetre, Of::kVariable},
    MeasureSpec{"force x", Measure::kForceX, unit::kNone, Of::kVariable},
    MeasureSpec{"force y", Measure::kForceY, unit::kNone, Of::kVariable},
    MeasureSpec{"score", Measure::kPoints, unit::kNone, Of::kScore},
    MeasureSpec{"deposited", Measure::kDeposited, unit::kNone, Of::kScore},
    MeasureSpec{"collisions", Measure::kCollisions, unit::kNone, Of::kScore},
    MeasureSpec{"elapsed", Measure::kElapsed, unit::kSecond, Of::kScore},
    MeasureSpec{"remaining", Measure::kRemaining, unit::kSecond, Of::kScore},
};

constexpr Unit kPercent{"%", "number", 0.01};
constexpr Unit kMicrosecond{"us", "time", 1e-6};

using Spelling = std::pair<std::string_view, std::string_view>;
constexpr std::array kEndings{
    Spelling{"_m", "m"},       Spelling{"_s", "s"},         Spelling{"_rad", "rad"},
    Spelling{"_mps", "m/s"},   Spelling{"_radps", "rad/s"}, Spelling{"_ms", "ms"},
    Spelling{"_us", "us"},     Spelling{"_deg", "deg"},     Spelling{"_cm", "cm"},
    Spelling{"_mm", "mm"},     Spelling{"_hz", "Hz"},       Spelling{"_px", "px"},
    Spelling{"_per_s", "1/s"},
};
constexpr std::array kOtherSpellings{
    Spelling{"sec", "s"},      Spelling{"secs", "s"},         Spelling{"second", "s"},
    Spelling{"seconds", "s"},  Spelling{"millisecond", "ms"}, Spelling{"milliseconds", "ms"},
    Spelling{"msec", "ms"},    Spelling{"minute", "min"},     Spelling{"minutes", "min"},
    Spelling{"metre", "m"},    Spelling{"metres", "m"},       Spelling{"meter", "m"},
    Spelling{"meters", "m"},   Spelling{"degree", "deg"},     Spelling{"degrees", "deg"},
    Spelling{"radian", "rad"}, Spelling{"radians", "rad"},    Spelling{"hz", "Hz"},
    Spelling{"HZ", "Hz"},      Spelling{"hertz", "Hz"},       Spelling{"Hertz", "Hz"},
    Spelling{"percent", "%"},  Spelling{"centimetres", "cm"}, Spelling{"centimeters", "cm"},
    Spelling{"S", "s"},        Spelling{"inches", "in"},      Spelling{"feet", "ft"},
};

}  // namespace

std::span<const MeasureSpec> measure_specs() noexcept {
  return kMeasures;
}

const MeasureSpec* find_measure(std::string_view name, bool of_variable) noexcept {
  const auto found = std::ranges::find_if(kMeasures, [&](const MeasureSpec& spec) {
    return spec.name == name && (spec.of == Of::kVariable) == of_variable;
  });
  return found == kMeasures.end() ? nullptr : &*found;
}

const MeasureSpec& spec_of(Measure measure) noexcept {
  return *std::ranges::find(kMeasures, measure, &MeasureSpec::measure);
}

Unit unit_of_field(std::string_view field) noexcept {
  Unit unit = unit::kNone;
  std::size_t longest = 0;
  for (const auto& [ending, symbol] : kEndings)
    if (ending.size() > longest && field.ends_with(ending)) {
      longest = ending.size();
      unit = find_expectation_unit(symbol).value_or(unit::kNone);
    }
  return unit;
}

std::optional<Unit> find_expectation_unit(std::string_view symbol) noexcept {
  if (symbol == kPercent.symbol) return kPercent;
  if (symbol == kMicrosecond.symbol) return kMicrosecond;
  return symbol.empty() ? std::nullopt : find_unit(symbol);
}

std::string_view meant_unit(std::string_view word) {
  for (const auto& [spelling, symbol] : kOtherSpellings)
    if (spelling == word) return symbol;
  return {};
}

}  // namespace galilean::expect
