// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/expectation_reader.h"

#include <algorithm>

#include "bhdl/check/expectation_specs.h"
#include "bhdl/check/value_or_nothing.h"
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

Claim::Kind claim_kind(std::string_view step) noexcept {
  if (step == "stays") return Claim::Kind::kStays;
  return step == "never" ? Claim::Kind::kNever : Claim::Kind::kReaches;
}

class ExpectationReader {
 public:
  ExpectationReader(const AttributeReader& attributes, Diagnostics& diagnostics)
      : attributes_(attributes), diagnostics_(diagnostics) {}

  Expectation read(const ExpectNode& node) {
    const auto values = attributes_.read(expect_spec(), node.keyword, node.attributes);
    Expectation result{.name = value_or_nothing<std::string>(values, "name"),
                       .from_state = value_or_nothing<std::string>(values, "from_state"),
                       .lasts_s = value_or_nothing<double>(values, "lasts"),
                       .location = node.keyword.at};
    for (const auto& step : node.steps) add(step, result);
    if (result.claims.empty())
      diagnostics_.error(node.keyword.at, "expect/nothing", "this expectation expects nothing",
                         "add a step with 'reaches:', 'stays:' or 'never:'");
    if (result.lasts_s == 0) result.lasts_s = last_time_s(result);
    return result;
  }

 private:
  void add(const ComponentNode& step, Expectation& to) {
    const auto specs = step_specs();
    const auto spec = std::ranges::find(specs, step.type.text, &ComponentSpec::name);
    if (spec == specs.end()) return refuse_unknown(step.type);
    const auto values = attributes_.read(*spec, step.type, step.attributes);
    const double from_s = value_or_nothing<double>(values, "from");
    const double until_s =
        value_or_nothing<double>(values, spec->name == "reaches" ? "by" : "until");
    if (until_s < from_s)
      diagnostics_.error(step.type.at, "value/out-of-range",
                         in_quotes(spec->name) + " ends before it begins: from " +
                             number_text(from_s) + " s to " + number_text(until_s) + " s");
    if (spec->name == "given")
      to.givens.push_back(given(step.type, values, from_s, until_s));
    else
      to.claims.push_back({claim_kind(spec->name), value_or_nothing<std::string>(values, "state"),
                           from_s, until_s, step.type.at});
  }

  Given given(const Word& type, const AttributeValues& values, double from_s, double until_s) {
    Given result{.bit_index = static_cast<unsigned>(value_or_nothing<double>(values, "bit_index")),
                 .bit_value = value_or_nothing<bool>(values, "bit_value"),
                 .position_m = value_or_nothing<Vec2>(values, "position"),
                 .heading_rad = value_or_nothing<double>(values, "heading"),
                 .force = value_or_nothing<Vec2>(values, "value"),
                 .valid = value_or_nothing<std::string>(values, "status") != "invalid",
                 .from_s = from_s,
                 .until_s = until_s,
                 .location = type.at};
    int variables = 0;
    for (const auto& each : given_spec().attributes) {
      if (each.refers_to.empty()) continue;
      auto name = value_or_nothing<std::string>(values, each.name);
      if (name.empty()) continue;
      result.variable = std::move(name);
      result.type = each.refers_to;
      ++variables;
    }
    if (variables != 1)
      diagnostics_.error(type.at, "value/count",
                         "'given' takes one of 'bits_variable', 'locate_variable', "
                         "'shaft_variable' and 'force_variable'");
    return result;
  }

  static double last_time_s(const Expectation& expectation) {
    double last_s = 0;
    const auto note = [&](double time_s) {
      if (time_s < kLongestExpectation_s) last_s = std::max(last_s, time_s);
    };
    for (const auto& each : expectation.givens) note(each.from_s), note(each.until_s);
    for (const auto& each : expectation.claims) note(each.from_s), note(each.until_s);
    return last_s;
  }

  void refuse_unknown(const Word& step) {
    const auto near = nearest(step.text, names_of(step_specs()));
    diagnostics_.error(
        step.at, "syntax/unknown-word", in_quotes(step.text) + " is no step of an expectation",
        near.empty() ? "steps are given, reaches, stays and never" : did_you_mean(near));
  }

  const AttributeReader& attributes_;
  Diagnostics& diagnostics_;
};

}  // namespace

Expectation read_expectation(const ExpectNode& node, const AttributeReader& attributes,
                             Diagnostics& diagnostics) {
  return ExpectationReader(attributes, diagnostics).read(node);
}

}  // namespace galilean::bhdl
