// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/team/team.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

template <class M>
bool note_as(Team& team, const Message& message) {
  M decoded;
  if (!msg::decode_cdr(*message.cdr, decoded)) return false;
  std::string replayed;
  if constexpr (requires { decoded.robot; })
    if (message.replayed) replayed = decoded.robot;
  team.note(std::move(decoded));
  if (!replayed.empty() && team.find(replayed)) team.note_replay(replayed);
  return true;
}

/// Returns how far the stamp of a state is ahead of this machine's clock. A stamp of a recording
/// says nothing of that.
double ahead_s(const msg::RobotState& state, const Message& message) {
  if (message.replayed || message.received_ns <= 0) return 0;
  return static_cast<double>(wire::since_epoch_ns(state.stamp) - message.received_ns) * 1e-9;
}

bool note_state(Team& team, const Message& message) {
  msg::RobotState state;
  if (!msg::decode_cdr(*message.cdr, state)) return false;
  const std::string robot = state.robot;
  const double clock_ahead_s = ahead_s(state, message);
  team.note(std::move(state));
  team.note_clock(robot, clock_ahead_s);
  if (message.replayed) team.note_replay(robot);
  return true;
}

bool note_transition(Team& team, const Message& message) {
  msg::Transition transition;
  if (!msg::decode_cdr(*message.cdr, transition)) return false;
  team.note(transition, message.filled);
  if (message.replayed) team.note_replay(transition.robot);
  return true;
}

using Note = bool (*)(Team&, const Message&);
constexpr std::array<std::pair<std::string_view, Note>, 9> kNotes{{
    {msg::RobotState::kRosType, note_state},
    {msg::Transition::kRosType, note_transition},
    {msg::Variables::kRosType, note_as<msg::Variables>},
    {msg::Program::kRosType, note_as<msg::Program>},
    {msg::Catalog::kRosType, note_as<msg::Catalog>},
    {msg::Breaks::kRosType, note_as<msg::Breaks>},
    {msg::ProgramReply::kRosType, note_as<msg::ProgramReply>},
    {msg::Score::kRosType, note_as<msg::Score>},
    {msg::ObjectMap::kRosType, note_as<msg::ObjectMap>},
}};

void add_filled(std::uint64_t number, std::vector<NumberRange>& ranges) {
  if (!ranges.empty() && ranges.back().last + 1 == number) {
    ranges.back().last = number;
    return;
  }
  ranges.push_back({number, number});
  if (ranges.size() > Robot::kFilledKept) ranges.erase(ranges.begin());
}

/// Forgets what a robot did before it was restarted. What it did since may be known already.
void forget_run_before(const msg::RobotState& last, Robot& robot) {
  robot.program_reply.reset();
  const auto end_ns = wire::since_epoch_ns(last.stamp);
  std::erase_if(robot.transitions, [&](const msg::Transition& transition) {
    return wire::since_epoch_ns(transition.stamp) <= end_ns;
  });
  std::erase_if(robot.filled, [&](const NumberRange& range) {
    return std::ranges::none_of(robot.transitions, [&](const msg::Transition& transition) {
      return range.first <= transition.number && transition.number <= range.last;
    });
  });
}

/// Returns the age as a duration that a clock can hold, whatever was sent.
Duration plausible_age(float age_s) {
  constexpr float kMost_s = 86400;
  return from_seconds(age_s >= 0 && age_s <= kMost_s ? age_s : kMost_s);
}

}  // namespace

std::string Robot::running_hash() const {
  if (!state) return {};
  // Ticks only go on, and a clock may be set.
  const bool reply_is_newer = program_reply && program_reply->tick > state->tick;
  return reply_is_newer ? program_reply->running_hash : state->program_hash;
}

bool Robot::is_filled(std::uint64_t transition) const noexcept {
  return std::ranges::any_of(filled, [&](const NumberRange& range) {
    return range.first <= transition && transition <= range.last;
  });
}

bool Team::receive(const Message& message) {
  for (const auto& [type, note_it] : kNotes)
    if (type == message.channel.schema->ros_type) return note_it(*this, message);
  return true;
}

Robot& Team::hear(const std::string& robot) {
  Robot& heard = robots_[robot];
  forgotten_.erase(robot);
  heard.name = robot;
  heard.heard = clock_.now();
  return heard;
}

void Team::note(msg::RobotState state) {
  Robot& robot = hear(state.robot);
  // A lower tick means that the robot was restarted, so ticks and transitions' numbers begin again.
  if (robot.state && state.tick < robot.state->tick) forget_run_before(*robot.state, robot);
  tally_.note(state);
  robot.state = std::move(state);
  robot.state_received = robot.heard;
}

void Team::note(const msg::Transition& transition, bool filled) {
  Robot& robot = hear(transition.robot);
  auto& known = robot.transitions;
  const auto at =
      std::lower_bound(known.begin(), known.end(), transition.number,
                       [](const auto& other, auto number) { return other.number < number; });
  if (at != known.end() && at->number == transition.number) {
    if (at->stamp == transition.stamp) return;
    *at = transition;  // of a robot that was restarted, and numbers its transitions anew
  } else {
    known.insert(at, transition);
  }
  if (filled) add_filled(transition.number, robot.filled);
  if (known.size() > Robot::kTransitionsKept) known.pop_front();
}

void Team::note(msg::Variables variables) {
  Robot& robot = hear(variables.robot);
  robot.variables = std::move(variables);
  robot.variables_received = robot.heard;
}

void Team::note(const msg::Program& program) {
  hear(program.robot).program = program;
}

void Team::note(const msg::Catalog& catalog) {
  hear(catalog.robot).catalog = catalog;
}

void Team::note(const msg::Breaks& breaks) {
  Robot& robot = hear(breaks.robot);
  robot.breaks = breaks;
  robot.breaks_received = robot.heard;
}

void Team::note(const msg::ProgramReply& reply) {
  const auto found = robots_.find(reply.robot);
  if (found == robots_.end() || reply.running_hash.empty()) return;
  auto& known = found->second.program_reply;
  // A reply that tells of no swap has no tick.
  if (!known || reply.tick >= known->tick) known = reply;
}

void Team::note(const msg::Score& score) {
  score_ = score;
  tally_.note(score);
}

void Team::note(const msg::ObjectMap& map) {
  for (const auto& told : map.robots) {
    if (robots_.contains(told.name) || forgotten_.contains(told.name) || !has_room_for(told))
      continue;
    Robot& robot = robots_[told.name];
    robot.name = told.name;
    robot.heard = clock_.now() - plausible_age(told.age_s);
  }
}

bool Team::has_room_for(const msg::MapRobot& told) {
  if (robots_.size() < kMostRobots) return true;
  if (plausible_age(told.age_s) >= RobotRoster::kForgetAfter) return false;
  const Robot* oldest = nullptr;
  for (const auto& [name, robot] : robots_)
    if (!robot.state && (!oldest || robot.heard < oldest->heard)) oldest = &robot;
  if (!oldest || clock_.now() - oldest->heard < RobotRoster::kForgetAfter) return false;
  forget(std::string(oldest->name));
  return robots_.size() < kMostRobots;
}

void Team::forget(const std::string& robot) {
  robots_.erase(robot);
  tally_.forget(robot);
  if (forgotten_.size() >= kMostRobots) forgotten_.clear();
  forgotten_.insert(robot);
}

const Robot* Team::find(std::string_view robot) const noexcept {
  const auto found = robots_.find(robot);
  return found == robots_.end() ? nullptr : &found->second;
}

double Team::age_s(const Robot& robot) const noexcept {
  return to_seconds(clock_.now() - robot.heard);
}

bool Team::silent(const Robot& robot) const noexcept {
  return clock_.now() - robot.heard > silent_after_;
}

// When a replay has ended nothing is heard any more, so that the robot stays a recorded one until
// it comes to life.
bool Team::replayed(const Robot& robot) const noexcept {
  return robot.replay_heard && robot.heard - *robot.replay_heard <= silent_after_;
}

std::vector<std::string> Team::replayed() const {
  std::vector<std::string> names;
  for (const auto& [name, robot] : robots_)
    if (replayed(robot)) names.push_back(name);
  return names;
}

std::map<std::string, int> Team::votes(bool of_recordings) const {
  std::map<std::string, int> votes;
  for (const auto& [name, robot] : robots_)
    if (const auto hash = robot.running_hash(); !hash.empty() && replayed(robot) == of_recordings)
      ++votes[hash];
  return votes;
}

std::string Team::program_hash() const {
  auto votes = this->votes(false);
  if (votes.empty()) votes = this->votes(true);
  if (votes.contains(pushed_hash_)) return pushed_hash_;
  const auto most = std::max_element(
      votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == votes.end() ? std::string() : most->first;
}

std::vector<RobotStatus> Team::statuses() const {
  const std::string team_hash = program_hash();
  std::vector<RobotStatus> result;
  for (const auto& [name, robot] : robots_) result.push_back(status(robot, team_hash));
  return result;
}

}  // namespace galilean::monitor
