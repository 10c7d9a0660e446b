// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/robot_watch.h"

#include <algorithm>
#include <utility>

#include "core/plural.h"
#include "core/wire/ros_time.h"
#include "monitor/expect/judge/needs.h"
#include "monitor/expect/judge/unknown_names.h"

namespace galilean::expect {
namespace {

/// A transition is published with the next state. One that is older by the robot's clock was sent
/// to a late joiner.
constexpr std::int64_t kSameMoment_ns = 250'000'000;
constexpr std::size_t kMostWaiting = 64;  ///< what a writer keeps for late joiners
constexpr std::size_t kMostNames = 10'000;

bool asks_for_states(const Claim& claim) {
  bool asks = false;
  for_each_condition(claim, [&](const Condition& condition) {
    const auto* name = std::get_if<NameIs>(&condition.kind);
    asks = asks || (name && name->what == NameIs::What::kState);
  });
  return asks;
}

}  // namespace

RobotWatch::RobotWatch(const std::string& robot, const TeamBelief& team, std::int64_t silence_ns,
                       const OnFailure& on_failure)
    : on_failure_(on_failure) {
  belief_.robot = robot;
  belief_.team = &team;
  belief_.silence_ns = silence_ns;
}

void RobotWatch::add(const Claim& claim) {
  Entry entry{&claim, nullptr, make_topic_monitor(claim), {}};
  if (entry.topic) {
    entry.topic_name = topic_of(claim)->of(belief_.robot);
  } else {
    for (const auto& name : variables_of(claim)) belief_.variables.try_emplace(name);
    entry.conditions = std::make_unique<ClaimWatch>(claim, belief_);
    if (on_failure_)
      entry.conditions->on_failure([this, &claim](std::int64_t at_ns, const std::string& values) {
        on_failure_({claim, belief_.robot, at_ns, values});
      });
  }
  entries_.push_back(std::move(entry));
}

void RobotWatch::advance(std::int64_t at_ns, unsigned sources) {
  for (const auto& entry : entries_)
    if (entry.conditions && (entry.conditions->sources() & sources) != 0)
      entry.conditions->advance(at_ns);
}

void RobotWatch::observe(std::int64_t at_ns, unsigned sources) {
  for (const auto& entry : entries_)
    if (entry.conditions && (entry.conditions->sources() & sources) != 0)
      entry.conditions->observe(at_ns);
}

void RobotWatch::sample(std::int64_t at_ns, const msg::RobotState& state) {
  const bool first = !heard();
  advance(at_ns, kState);
  if (first)
    begin(state);
  else if (state.tick < newest_tick_)
    restart();
  newest_tick_ = state.tick;
  belief_.state.set(at_ns, state);
  if (state.transitions >= belief_.transitions) {
    if (!first) note_number(at_ns, state.transitions);
    belief_.current_state = state.state;
    belief_.transitions = state.transitions;
    numbered_ns_ = at_ns;
  }
  observe(at_ns, kState);
  if (!first) return;
  for (const auto& transition : waiting_) deliver(at_ns, transition);
  waiting_.clear();
}

void RobotWatch::begin(const msg::RobotState& state) {
  first_stamp_ns_ = wire::since_epoch_ns(state.stamp);
  first_number_ = state.transitions;
}

void RobotWatch::restart() {
  lost_ = lost_transitions();
  delivered_ = 0;
  first_number_ = 0;
  missed_states_.restart();
  belief_.transitions = 0;
}

/// Takes that the robot has come to this transition since the one that was known last.
void RobotWatch::note_number(std::int64_t at_ns, std::uint64_t transition) {
  missed_states_.pass(belief_.transitions, transition, inside({numbered_ns_, at_ns}));
}

void RobotWatch::sample(std::int64_t at_ns, const msg::Transition& transition) {
  if (heard()) return deliver(at_ns, transition);
  if (waiting_.size() == kMostWaiting) waiting_.pop_front();
  waiting_.push_back(transition);
}

bool RobotWatch::happened_before(const msg::Transition& transition) const {
  return wire::since_epoch_ns(transition.stamp) < first_stamp_ns_ - kSameMoment_ns;
}

void RobotWatch::deliver(std::int64_t at_ns, const msg::Transition& transition) {
  if (happened_before(transition)) return;
  constexpr unsigned kAffected = kState | kTransitions;
  advance(at_ns, kAffected);
  if (transition.number > first_number_) ++delivered_;
  if (transition.number > belief_.transitions) {
    note_number(at_ns, transition.number);
    belief_.transitions = transition.number;
    belief_.current_state = transition.to_state;
    numbered_ns_ = at_ns;
    return show(at_ns, transition);
  }
  if (!missed_states_.find(transition.number)) return show(at_ns, transition);
  // It is told after a later state, but the robot was in its state before that one.
  const auto newest = std::exchange(belief_.current_state, transition.to_state);
  show(at_ns, transition);
  belief_.current_state = newest;
  observe(at_ns, kTransitions);
}

/// Has the claims see a transition, and then that it is over.
void RobotWatch::show(std::int64_t at_ns, const msg::Transition& transition) {
  belief_.event = &transition;
  observe(at_ns, kTransitions);
  belief_.event = nullptr;
  observe(at_ns, kTransitions);
}

std::uint64_t RobotWatch::lost_transitions() const noexcept {
  const std::uint64_t happened =
      belief_.transitions > first_number_ ? belief_.transitions - first_number_ : 0;
  return lost_ + (happened > delivered_ ? happened - delivered_ : 0);
}

void RobotWatch::sample(std::int64_t at_ns, const msg::Variables& variables) {
  advance(at_ns, kVariables);
  if (!belief_.variables_ns)
    for (const auto& item : variables.items)
      if (variables_.size() < kMostNames) variables_.insert(item.name);
  belief_.set_variables(at_ns, variables);
  observe(at_ns, kVariables);
}

void RobotWatch::sample(const msg::Program& program) {
  for (const auto& state : program.states)
    if (states_.size() < kMostNames) states_.insert(state.name);
}

void RobotWatch::message(std::int64_t at_ns, std::string_view topic, const Numbered& number) {
  for (const auto& entry : entries_)
    if (entry.topic && entry.topic_name == topic) entry.topic->message(at_ns, number);
}

void RobotWatch::missed(std::string_view topic, std::optional<std::uint64_t> messages) {
  for (const auto& entry : entries_)
    if (entry.topic && entry.topic_name == topic) entry.topic->missed(messages);
}

std::string RobotWatch::complaint_on_names(const Claim& claim) const {
  if (!states_.empty())
    for (const auto& name : states_of(claim))
      if (!states_.contains(name))
        return unknown_name(belief_.robot + "'s program", "state", name, states_);
  if (belief_.variables_ns)
    for (const auto& name : variables_of(claim))
      if (belief_.variables.at(name).type == 0)
        return unknown_name(belief_.robot, "variable", name, variables_);
  return {};
}

std::string RobotWatch::unknown_names() const {
  for (const auto& entry : entries_)
    if (auto complaint = complaint_on_names(*entry.claim); !complaint.empty()) return complaint;
  return {};
}

/// Turns an outcome that rests on what is not known into "cannot tell".
void RobotWatch::settle(const Claim& claim, const std::set<std::string>& heard_robots,
                        Finding& finding) const {
  const auto doubt = [&](std::string reason) {
    finding.outcome = Outcome::kCannotTell;
    finding.reason = std::move(reason);
  };
  if (!belief_.robot.empty() && !heard() && topic_of(claim) == nullptr)
    return doubt(belief_.robot + " was never heard" + meant_robot(belief_.robot, heard_robots));
  if (auto complaint = complaint_on_names(claim); !complaint.empty())
    return doubt(std::move(complaint));
  if (asks_for_states(claim))
    doubt_where(missed_states_.times(),
                belief_.robot + " was in states then that the recording does not tell", finding);
  const auto lost = lost_transitions();
  bool of_transitions = false;
  for_each_condition(claim, [&](const Condition& condition) {
    of_transitions = of_transitions || std::holds_alternative<Transition>(condition.kind);
  });
  if (!of_transitions || lost == 0) return;
  const auto& wrong = finding.counterexamples;
  const bool rests = finding.outcome == Outcome::kHolds
                         ? finding.needs.has_value()
                         : std::ranges::all_of(wrong, [](const Counterexample& each) {
                             return each.needs.has_value();
                           });
  if (rests) doubt("the recording lacks " + plural(lost, "transition") + " of " + belief_.robot);
}

std::vector<Finding> RobotWatch::finish(std::int64_t end_ns,
                                        const std::set<std::string>& heard_robots) {
  std::vector<Finding> findings;
  for (const auto& entry : entries_) {
    findings.push_back(entry.conditions ? entry.conditions->finish(end_ns)
                                        : entry.topic->finish(end_ns));
    settle(*entry.claim, heard_robots, findings.back());
    if (entry.topic && !entry.topic->any())
      findings.back().reason += meant_topic(*topic_of(*entry.claim), belief_.robot, heard_robots);
  }
  return findings;
}

}  // namespace galilean::expect
