// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/wire/messages.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor::top {
namespace {

constexpr std::size_t kMostPoints = 48;
constexpr double kInvalid = std::numeric_limits<double>::quiet_NaN();

using Numbers = std::vector<std::pair<std::string, double>>;

/// Returns the number that a variable's curve shows: a shaft's speed, a position's certainty, the
/// bits, or the length of a force.
double curve_value(const msg::Variable& variable) {
  namespace types = msg::Variable_Constants;
  const auto& v = variable.values;
  if (!variable.valid || v.empty()) return kInvalid;
  if (variable.type == types::SHAFT) return v.size() >= 4 ? v[3] : kInvalid;
  if (variable.type == types::LOCATE) return variable.certainty;
  if (variable.type == types::FORCE) return v.size() >= 2 ? std::hypot(v[0], v[1]) : kInvalid;
  return variable.type == types::BITS ? v[0] : kInvalid;
}

Numbers numbers_in(const std::vector<std::uint8_t>& cdr) {
  msg::Variables variables;
  Numbers numbers;
  if (!msg::decode_cdr(cdr, variables)) return numbers;
  for (auto& variable : variables.items)
    numbers.emplace_back(std::move(variable.name), curve_value(variable));
  return numbers;
}

/// Returns the number of that name; nullptr if there is none. A program has its variables in one
/// order, so `place` is where it mostly stands.
const double* number_of(const std::string& name, std::size_t place, const Numbers& numbers) {
  if (place < numbers.size() && numbers[place].first == name) return &numbers[place].second;
  const auto found = std::ranges::find(numbers, name, &Numbers::value_type::first);
  return found == numbers.end() ? nullptr : &found->second;
}

}  // namespace

void Curves::recall(const std::vector<History::Sample>& samples) {
  std::deque<Point> points;
  for (const auto& sample : samples) {
    const auto known = std::ranges::find(points_, sample.cdr, &Point::cdr);
    if (known == points_.end())
      points.push_back({sample.cdr, numbers_in(*sample.cdr)});
    else
      points.push_back(std::move(*known));
  }
  points_ = std::move(points);
}

std::vector<std::vector<double>> Curves::of(const Robot& robot, Time then) {
  recall(history_.until(wire::robot_topic(robot.name, "variables"), then, kMostPoints));
  std::vector<std::vector<double>> curves(robot.variables.items.size());
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const auto& point : points_)
      if (const auto* number = number_of(robot.variables.items[i].name, i, point.numbers))
        curves[i].push_back(*number);
  return curves;
}

}  // namespace galilean::monitor::top
