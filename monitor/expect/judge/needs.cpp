// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/needs.h"

#include "monitor/expect/judge/topic_monitors.h"
#include "monitor/expect/language/measures.h"

namespace galilean::expect {
namespace {

struct SourceOf {
  unsigned operator()(const Comparison& comparison) const {
    if (comparison.measure == Measure::kField) return kFields;
    if (comparison.measure == Measure::kDistance) return kVariables | kState;
    switch (spec_of(comparison.measure).of) {
      case MeasureSpec::Of::kRobot:
        return kState;
      case MeasureSpec::Of::kVariable:
        return kVariables;
      case MeasureSpec::Of::kScore:
        break;
    }
    return kScore;
  }
  unsigned operator()(const NameIs& condition) const {
    switch (condition.what) {
      case NameIs::What::kState:
        return kState | kTransitions;
      case NameIs::What::kProgram:
        return kState;
      case NameIs::What::kPhase:
        return kScore;
      case NameIs::What::kField:
        break;
    }
    return kFields;
  }
  unsigned operator()(const RobotIs&) const { return kState; }
  unsigned operator()(const VariableIsValid&) const { return kVariables; }
  unsigned operator()(const BitIs&) const { return kVariables; }
  unsigned operator()(const Transition&) const { return kState | kTransitions; }
  template <class Composed>
  unsigned operator()(const Composed&) const {
    return 0;
  }
};

const TopicName* field_topic(const Condition& condition) {
  const auto* comparison = std::get_if<Comparison>(&condition.kind);
  if (comparison && comparison->measure == Measure::kField) return &comparison->topic;
  const auto* name = std::get_if<NameIs>(&condition.kind);
  return name && name->what == NameIs::What::kField ? &name->topic : nullptr;
}

}  // namespace

unsigned sources_of(const Claim& claim) {
  unsigned sources = 0;
  for_each_condition(claim, [&](const Condition& condition) {
    sources |= std::visit(SourceOf{}, condition.kind);
  });
  return sources;
}

std::set<std::string> variables_of(const Claim& claim) {
  std::set<std::string> names;
  for_each_condition(claim, [&](const Condition& condition) {
    std::visit(
        [&](const auto& kind) {
          if constexpr (requires { kind.variable; })
            if (!kind.variable.empty()) names.insert(kind.variable);
        },
        condition.kind);
  });
  return names;
}

std::set<std::string> states_of(const Claim& claim) {
  std::set<std::string> names;
  for_each_condition(claim, [&](const Condition& condition) {
    const auto* name = std::get_if<NameIs>(&condition.kind);
    if (name && name->what == NameIs::What::kState)
      names.insert(name->texts.begin(), name->texts.end());
    if (const auto* transition = std::get_if<Transition>(&condition.kind))
      names.insert({transition->from, transition->to});
  });
  names.erase("");
  return names;
}

std::string_view robot_of(std::string_view topic) {
  if (!topic.starts_with('/')) return {};
  const auto end = topic.find('/', 1);
  return end == std::string_view::npos ? std::string_view() : topic.substr(1, end - 1);
}

bool TopicSet::contains(std::string_view topic) const {
  if (topics_.empty()) return false;
  if (topics_.contains(topic)) return true;
  const auto robot = robot_of(topic);
  return !robot.empty() && topics_.contains("~" + std::string(topic.substr(1 + robot.size())));
}

Needs::Needs(const std::vector<Expectation>& expectations) {
  for (const auto& expectation : expectations)
    for (const auto& claim : expectation.claims) {
      sources |= sources_of(claim);
      if (const auto* topic = topic_of(claim)) messages.add(*topic);
      for_each_condition(claim, [&](const Condition& condition) {
        if (const auto* topic = field_topic(condition)) fields.add(*topic);
      });
    }
}

}  // namespace galilean::expect
