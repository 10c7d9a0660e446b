// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/program/value_words.h"

#include <array>
#include <charconv>

#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

struct ValueInWords {
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(double value) const { return number_text(value); }
  std::string operator()(const Vec2& value) const {
    return "<" + number_text(value.x()) + ", " + number_text(value.y()) + ">";
  }
  std::string operator()(const std::string& value) const { return "\"" + value + "\""; }
  template <class Item>
  std::string operator()(const std::vector<Item>& values) const {
    std::string text;
    for (const auto& value : values) text += (text.empty() ? "" : " ") + (*this)(value);
    return text;
  }
};

double rounded(double number) {
  constexpr int kDigits = 12;
  std::array<char, 40> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                     std::chars_format::general, kDigits);
  double result = number;
  std::from_chars(digits.data(), written.ptr, result);
  return result;
}

}  // namespace

std::string value_in_words(const Value& value) {
  return std::visit(ValueInWords{}, value);
}

std::string value_in_words(const Value& value, const Unit& unit) {
  const std::string words = value_in_words(value);
  return unit.symbol.empty() || words.empty() ? words : words + " " + std::string(unit.symbol);
}

Value from_si(Value value, const Unit& unit) {
  const auto convert = [&](double si) { return rounded(si / unit.to_si); };
  if (auto* number = std::get_if<double>(&value)) *number = convert(*number);
  if (auto* pair = std::get_if<Vec2>(&value)) *pair = {convert(pair->x()), convert(pair->y())};
  if (auto* numbers = std::get_if<std::vector<double>>(&value))
    for (double& each : *numbers) each = convert(each);
  return value;
}

}  // namespace galilean::bhdl
