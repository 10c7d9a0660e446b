// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bhdl/source/location.h"
#include "core/catalog/unit.h"

namespace galilean::expect {

/// A quantity that can be compared with a number.
enum class Measure {
  kRobotX,
  kRobotY,
  kRobotHeading,
  kTickTime,
  kTickOverruns,
  kProblems,
  kCertainty,
  kVariableX,
  kVariableY,
  kVariableHeading,
  kSpeed,
  kTurnRate,
  kRadius,
  kForceX,
  kForceY,
  kDistance,
  kPoints,
  kDeposited,
  kCollisions,
  kElapsed,
  kRemaining,
  kField
};

enum class Operator { kEqual, kUnequal, kLess, kAtMost, kGreater, kAtLeast };
/// Returns the operator as it is written, such as ">=".
[[nodiscard]] std::string to_string(Operator op);
[[nodiscard]] bool holds(double value, Operator op, double limit) noexcept;
/// Returns how far the value is from where the comparison would change. It is negative if the
/// comparison does not hold.
[[nodiscard]] double margin(double value, Operator op, double limit) noexcept;

/// A topic as it is written. `~/state` is /NAME/state of the robot in question.
struct TopicName {
  std::string text;
  /// Returns the topic's full name. Requires: a relative topic has a robot.
  [[nodiscard]] std::string of(const std::string& robot) const;
  [[nodiscard]] bool relative() const noexcept { return text.starts_with('~'); }
};

struct Condition;
/// All parts hold, or any of them does.
struct AllOf {
  std::vector<Condition> parts;
};
struct AnyOf {
  std::vector<Condition> parts;
};
struct Not {
  std::vector<Condition> part;  ///< exactly one
};
struct Comparison {
  Measure measure = Measure::kField;
  std::string variable;  ///< of a measure of a variable
  TopicName topic;       ///< of a field
  std::string field;
  Operator op = Operator::kEqual;
  double limit = 0;  ///< in the unit's dimension, SI
  Unit unit;         ///< as written; that of 0 without a unit is the measure's own
};
/// A name is one of these texts.
struct NameIs {
  enum class What { kState, kProgram, kPhase, kField };
  What what = What::kState;
  TopicName topic;  ///< of a field
  std::string field;
  std::vector<std::string> texts;
};
struct RobotIs {
  enum class What { kHealthy, kHeld, kInProbation, kOutOfService };
  What what = What::kHealthy;
};
struct VariableIsValid {
  std::string variable;
};
struct BitIs {
  std::string variable;
  int bit = 0;
  bool value = true;
};
/// A change of state, which is true at its instant only. An empty text matches any.
struct Transition {
  std::string from, to;
  std::string cause;  ///< a part of Transition.cause
};
struct Condition {
  std::variant<AllOf, AnyOf, Not, Comparison, NameIs, RobotIs, VariableIsValid, BitIs, Transition>
      kind;
  bhdl::Location at;
};

// Times are in seconds.
struct Always {
  Condition condition;
};
struct Never {
  Condition condition;
  std::optional<double> for_s;
};
struct Eventually {
  Condition condition;
  std::optional<double> within_s, for_s;
};
struct After {
  Condition trigger, response;
  double within_s = 0;
};
struct Until {
  Condition condition, end;
  std::optional<double> within_s;
};
struct AtEnd {
  Condition condition;
};
/// The largest limit of a count in a window of time.
inline constexpr std::size_t kMostInWindow = 100'000;
struct Count {
  /// What is counted: how often a condition comes true, or messages.
  std::variant<Condition, TopicName> what;
  std::optional<double> window_s;  ///< in any so many seconds; else in the whole recording
  Operator op = Operator::kEqual;
  double limit = 0;
};
struct Rate {
  TopicName topic;
  Operator op = Operator::kAtLeast;
  double limit_hz = 0;
};
struct NoGaps {
  TopicName topic;
  double longest_s = 0;
};
struct Losses {
  TopicName topic;
  Operator op = Operator::kEqual;
  double limit = 0;
};

struct Claim {
  std::variant<Always, Never, Eventually, After, Until, AtEnd, Count, Rate, NoGaps, Losses> kind;
  std::string text;  ///< as written, on one line
  bhdl::Location at;
};

struct Scope {
  enum class Who { kEvery, kSome, kNamed, kTeam };
  Who who = Who::kTeam;
  std::string robot;  ///< of kNamed
};

struct Expectation {
  Scope scope;
  std::vector<Claim> claims;
  std::string text;  ///< as written, on one line
  bhdl::Location at;
};

/// Calls `visit` with each condition of a claim, from the outside in.
template <class Visit>
void for_each_condition(const Condition& condition, const Visit& visit) {
  visit(condition);
  const auto each = [&](const std::vector<Condition>& parts) {
    for (const auto& part : parts) for_each_condition(part, visit);
  };
  if (const auto* all = std::get_if<AllOf>(&condition.kind)) each(all->parts);
  if (const auto* any = std::get_if<AnyOf>(&condition.kind)) each(any->parts);
  if (const auto* negated = std::get_if<Not>(&condition.kind)) each(negated->part);
}
template <class Visit>
void for_each_condition(const Claim& claim, const Visit& visit) {
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.condition; }) for_each_condition(kind.condition, visit);
        if constexpr (requires { kind.trigger; }) for_each_condition(kind.trigger, visit);
        if constexpr (requires { kind.response; }) for_each_condition(kind.response, visit);
        if constexpr (requires { kind.end; }) for_each_condition(kind.end, visit);
        if constexpr (requires { kind.what; })
          if (const auto* counted = std::get_if<Condition>(&kind.what))
            for_each_condition(*counted, visit);
      },
      claim.kind);
}

}  // namespace galilean::expect
