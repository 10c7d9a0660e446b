// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/judge.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/plural.h"
#include "monitor/expect/judge/collect.h"

namespace galilean::expect {
namespace {

constexpr std::size_t kMostRobots = 1000, kMostNotes = 20;

}  // namespace

Judge::Judge(const std::vector<Expectation>& expectations, JudgeOptions options)
    : expectations_(expectations),
      options_(std::move(options)),
      needs_(expectations),
      team_({}, team_belief_, options_.silence.count(), options_.on_failure) {
  for (const auto& expectation : expectations) {
    if (expectation.scope.who == Scope::Who::kNamed) (void)watch(expectation.scope.robot);
    if (expectation.scope.who != Scope::Who::kTeam) continue;
    for (const auto& claim : expectation.claims) team_.add(claim);
  }
}

Judge::~Judge() = default;

RobotWatch* Judge::watch(std::string_view robot) {
  const auto known = robots_.find(robot);
  if (known != robots_.end()) return known->second.get();
  // The team is what has no name.
  if (robot.empty() || robots_.size() >= kMostRobots) return ++refused_, nullptr;
  const std::string name(robot);
  auto made = std::make_unique<RobotWatch>(name, team_belief_, options_.silence.count(),
                                           options_.on_failure);
  for (const auto& expectation : expectations_)
    if (concerns(expectation.scope, name))
      for (const auto& claim : expectation.claims) made->add(claim);
  return robots_.emplace(name, std::move(made)).first->second.get();
}

std::int64_t Judge::in_order(std::int64_t at_ns) noexcept {
  if (at_ns < now_ns_) ++late_;
  return now_ns_ = std::max(now_ns_, at_ns);
}

bool Judge::wants_messages(std::string_view topic) const {
  return needs_.messages.contains(topic);
}

bool Judge::wants_fields(std::string_view topic) const {
  return needs_.fields.contains(topic);
}

bool Judge::wants_type(std::string_view ros_type) const {
  const auto is = [&](const char* type, unsigned source) {
    return ros_type == type && (source == 0 || (needs_.sources & source) != 0);
  };
  return is(msg::RobotState::kRosType, 0) || is(msg::Program::kRosType, 0) ||
         is(msg::Transition::kRosType, kTransitions) || is(msg::Variables::kRosType, kVariables) ||
         is(msg::Score::kRosType, kScore);
}

void Judge::message(std::int64_t at_ns, std::string_view topic, const Numbered& number) {
  at_ns = in_order(at_ns);
  // A robot's topic may be heard before its state, from which a robot is otherwise known.
  if (const auto robot = robot_of(topic); !robot.empty()) (void)watch(robot);
  team_.message(at_ns, topic, number);
  for (const auto& [name, robot] : robots_) robot->message(at_ns, topic, number);
}

void Judge::missed(std::string_view topic, std::optional<std::uint64_t> messages) {
  team_.missed(topic, messages);
  for (const auto& [name, robot] : robots_) robot->missed(topic, messages);
}

template <class Apply>
void Judge::share(std::int64_t at_ns, unsigned source, const Apply& apply) {
  team_.advance(at_ns, source);
  for (const auto& [name, robot] : robots_) robot->advance(at_ns, source);
  apply();
  team_.observe(at_ns, source);
  for (const auto& [name, robot] : robots_) robot->observe(at_ns, source);
}

void Judge::fields(std::int64_t at_ns, std::string_view topic,
                   const monitor::MessageTree& message) {
  share(in_order(at_ns), kFields, [&] {
    const auto known = team_belief_.fields.find(topic);
    if (known != team_belief_.fields.end())
      known->second = message;
    else
      team_belief_.fields.emplace(topic, message);
  });
}

void Judge::sample(std::int64_t at_ns, const msg::Score& score) {
  at_ns = in_order(at_ns);
  share(at_ns, kScore, [&] { team_belief_.score.set(at_ns, score); });
}

void Judge::sample(std::int64_t at_ns, const msg::RobotState& state) {
  at_ns = in_order(at_ns);
  if (auto* robot = watch(state.robot)) robot->sample(at_ns, state);
}

void Judge::sample(std::int64_t at_ns, const msg::Transition& transition) {
  at_ns = in_order(at_ns);
  if (auto* robot = watch(transition.robot)) robot->sample(at_ns, transition);
}

void Judge::sample(std::int64_t at_ns, const msg::Variables& variables) {
  at_ns = in_order(at_ns);
  if (auto* robot = watch(variables.robot)) robot->sample(at_ns, variables);
}

void Judge::sample(std::int64_t at_ns, const msg::Program& program) {
  (void)in_order(at_ns);
  if (auto* robot = watch(program.robot)) robot->sample(program);
}

void Judge::damage(const Span& span, const std::string& why) {
  damage_.add(span);
  if (!why.empty() && notes_.size() < kMostNotes) notes_.push_back(why);
}

std::vector<std::string> Judge::unknown_names() const {
  std::vector<std::string> sentences;
  for (const auto& [name, robot] : robots_)
    if (auto sentence = robot->unknown_names(); !sentence.empty())
      sentences.push_back(std::move(sentence));
  return sentences;
}

Judgement Judge::finish(std::int64_t begin_ns, std::int64_t end_ns) {
  Judgement judgement;
  judgement.begin_ns = begin_ns;
  judgement.end_ns = std::max(end_ns, now_ns_);
  Collected collected;
  std::set<std::string> heard;
  for (const auto& [name, robot] : robots_)
    if (robot->heard()) heard.insert(name);
  const auto take = [&](const std::string& name, RobotWatch& robot) {
    auto findings = robot.finish(judgement.end_ns, heard);
    for (auto& finding : findings)
      doubt_where(damage_, "messages of that time are missing", finding);
    collected[name] = {robot.heard(), std::move(findings)};
  };
  take({}, team_);
  for (const auto& [name, robot] : robots_) take(name, *robot);
  judgement.verdicts = collect(expectations_, collected);
  judgement.notes = std::move(notes_);
  if (late_ > 0)
    judgement.notes.push_back(
        plural(late_, "message") +
        agreeing(late_, " was older than that before it, and is judged as if it came then",
                 " were older than those before, and are judged as if they came then"));
  if (refused_ > 0)
    judgement.notes.push_back("more than " + std::to_string(kMostRobots) +
                              " robots were heard, or some without a name; those are not judged");
  return judgement;
}

}  // namespace galilean::expect
