// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/value_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bhdl/check/constants.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "core/plural.h"

namespace galilean::bhdl {
namespace {

using Kind = ValueNode::Kind;

std::string number_with_unit(std::string text, const Unit* unit) {
  return unit == nullptr ? text : text.append(" ").append(unit->symbol);
}

std::string in_words(const ValueNode& value) {
  switch (value.kind) {
    case Kind::kNumber:
      return "the number " + number_with_unit(std::string(value.text), value.unit);
    case Kind::kPair:
      return "the pair <" + number_with_unit(number_text(value.number), value.unit) + ", " +
             number_with_unit(number_text(value.second), value.second_unit) + ">";
    case Kind::kText:
      return "the text " + in_quotes(value.text);
    default:
      return "the word " + in_quotes(value.text);
  }
}

/// Returns a hint such as "write it in cm, m …".
std::string units_of(const Unit& expected) {
  if (expected.symbol.empty()) return "write the number alone";
  std::string text = "write it in " + std::string(expected.symbol);
  for (const auto& unit : all_units())
    if (unit.dimension == expected.dimension && unit.symbol != expected.symbol)
      text.append(", ").append(unit.symbol);
  return text;
}

// A result next to a limit becomes the limit. Otherwise the arithmetic's rounding could put 0.3 m
// just above 30 cm, and out of range.
double converted(double number, const Unit& from, const AttributeSpec& spec) {
  const double result = number * (from.to_si / spec.unit.to_si);
  for (const double limit : {spec.minimum, spec.maximum})
    if (std::isfinite(limit) && std::abs(result - limit) <= 1e-12 * std::abs(limit)) return limit;
  return result;
}

class ValueReader {
 public:
  ValueReader(const AttributeNode& attribute, const AttributeSpec& spec,
              const AttributeContext& context, Diagnostics& diagnostics)
      : attribute_(attribute), spec_(spec), context_(context), diagnostics_(diagnostics) {}

  std::optional<Value> read() {
    const auto broken = [](const ValueNode& value) { return value.kind == Kind::kBroken; };
    if (std::ranges::any_of(attribute_.values, broken)) return std::nullopt;
    if (!count_fits()) return std::nullopt;
    switch (spec_.type) {
      case AttributeType::kNumbers:
        return list<double>([this](const ValueNode& value) { return number(value); });
      case AttributeType::kNames:
        return list<std::string>([this](const ValueNode& value) { return text(value); });
      default:
        return single(attribute_.values.front());
    }
  }

 private:
  std::optional<Value> single(const ValueNode& value) {
    switch (spec_.type) {
      case AttributeType::kFlag:
        return wrapped(flag(value));
      case AttributeType::kPair:
        return wrapped(pair(value));
      case AttributeType::kChoice:
        return wrapped(choice(value));
      case AttributeType::kText:
      case AttributeType::kName:
        return wrapped(text(value));
      default:
        return wrapped(number(value));
    }
  }

  template <class T>
  static std::optional<Value> wrapped(std::optional<T> value) {
    return value ? std::optional(Value(std::move(*value))) : std::nullopt;
  }

  template <class T, class ReadOne>
  std::optional<Value> list(ReadOne read_one) {
    std::vector<T> items;
    for (const auto& value : attribute_.values)
      if (auto item = read_one(value)) items.push_back(std::move(*item));
    if (items.size() != attribute_.values.size()) return std::nullopt;
    return Value(std::move(items));
  }

  bool count_fits() {
    const bool any = spec_.type == AttributeType::kNumbers || spec_.type == AttributeType::kNames;
    const std::size_t given = attribute_.values.size();
    const std::size_t expected = any ? spec_.count : 1;
    if ((any && expected == 0) || given == expected) return true;
    diagnostics_.error(attribute_.name.at, "value/count",
                       subject() + " takes " + expectation(spec_) + "; " + std::to_string(given) +
                           agreeing(given, " value is given", " values are given"));
    return false;
  }

  std::optional<bool> flag(const ValueNode& value) {
    constexpr std::array<std::string_view, 3> kYes{"yes", "true", "on"};
    constexpr std::array<std::string_view, 3> kNo{"no", "false", "off"};
    const std::string word = lower_case(value.text);
    const bool number = value.kind == Kind::kNumber;
    if (number && !dimension_fits(value.unit, value)) return std::nullopt;
    if (number ? value.number == 1 : std::ranges::find(kYes, word) != kYes.end()) return true;
    if (number ? value.number == 0 : std::ranges::find(kNo, word) != kNo.end()) return false;
    return refuse_type<bool>(value);
  }

  std::optional<double> number(const ValueNode& value) {
    if (value.kind != Kind::kNumber) return refuse_type<double>(value);
    const auto number = in_own_unit(value.number, value.unit, value);
    if (!number) return std::nullopt;
    if (spec_.type == AttributeType::kInteger && *number != std::floor(*number))
      return refuse_type<double>(value);
    return in_range(*number, value) ? number : std::nullopt;
  }

  std::optional<Vec2> pair(const ValueNode& value) {
    if (value.kind != Kind::kPair) return refuse_type<Vec2>(value);
    const auto first = in_own_unit(value.number, value.unit, value);
    if (!first) return std::nullopt;
    const auto second = in_own_unit(value.second, value.second_unit, value);
    if (!second || !in_range(*first, value) || !in_range(*second, value)) return std::nullopt;
    return Vec2(*first, *second);
  }

  /// Returns the number in the catalog's unit. A bare number is in that unit already.
  std::optional<double> in_own_unit(double number, const Unit* given, const ValueNode& value) {
    if (given == nullptr || given->symbol == spec_.unit.symbol) return number;
    if (!dimension_fits(given, value)) return std::nullopt;
    return converted(number, *given, spec_);
  }

  bool dimension_fits(const Unit* given, const ValueNode& value) {
    if (given == nullptr || given->dimension == spec_.unit.dimension) return true;
    report(value, "type/wrong-unit",
           subject() + " takes " + expectation(spec_) + ", not " + in_words(value) + ": " +
               in_quotes(given->symbol) + " is a unit of " + std::string(given->dimension),
           units_of(spec_.unit));
    return false;
  }

  std::optional<std::string> text(const ValueNode& value) {
    if (value.kind == Kind::kText) return std::string(value.text);
    const bool bare = value.kind == Kind::kBareWord;
    return refuse_type<std::string>(value, bare ? "write \"" + std::string(value.text) + "\"" : "");
  }

  // The listings quote their choices. A choice without quotes is accepted too.
  std::optional<std::string> choice(const ValueNode& value) {
    if (value.kind != Kind::kText && value.kind != Kind::kBareWord)
      return refuse_type<std::string>(value);
    if (std::ranges::find(spec_.choices, value.text) != spec_.choices.end())
      return std::string(value.text);
    const std::vector<std::string_view> choices(spec_.choices.begin(), spec_.choices.end());
    report(value, "value/not-a-choice",
           subject() + " is " + expectation(spec_) + ", not " + in_quotes(value.text),
           did_you_mean(nearest(value.text, choices)));
    return std::nullopt;
  }

  bool in_range(double number, const ValueNode& value) {
    if (number >= spec_.minimum && number <= spec_.maximum) return true;
    report(value, "value/out-of-range",
           subject() + " is out of range: " + number_text(number) + " is not " +
               (std::isfinite(spec_.minimum) && std::isfinite(spec_.maximum) ? "within " : "") +
               range_in_words(spec_));
    return false;
  }

  template <class T>
  std::optional<T> refuse_type(const ValueNode& value, Hint hint = {}) {
    report(value, "type/wrong-value",
           subject() + " takes " + expectation(spec_) + ", not " + in_words(value),
           std::move(hint));
    return std::nullopt;
  }

  void report(const ValueNode& value, std::string_view code, std::string message, Hint hint = {}) {
    diagnostics_.error(value.at, code, std::move(message) + definition_note(value),
                       std::move(hint));
  }

  [[nodiscard]] std::string subject() const {
    return in_quotes(spec_.name) + " of " + label(context_);
  }

  const AttributeNode& attribute_;
  const AttributeSpec& spec_;
  const AttributeContext& context_;
  Diagnostics& diagnostics_;
};

}  // namespace

Value to_si(Value value, const Unit& unit) {
  if (auto* number = std::get_if<double>(&value)) *number *= unit.to_si;
  if (auto* pair = std::get_if<Vec2>(&value)) *pair *= unit.to_si;
  if (auto* numbers = std::get_if<std::vector<double>>(&value))
    for (double& each : *numbers) each *= unit.to_si;
  return value;
}

std::optional<Value> read_value(const AttributeNode& attribute, const AttributeSpec& spec,
                                const AttributeContext& context, Diagnostics& diagnostics) {
  auto value = ValueReader(attribute, spec, context, diagnostics).read();
  if (!value) return std::nullopt;
  return to_si(std::move(*value), spec.unit);
}

}  // namespace galilean::bhdl
