// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/order_session.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/account.h"
#include "core/command_line/domain_option.h"
#include "core/visible_text.h"
#include "core/wire/neighbours.h"
#include "monitor/orders/break_answer.h"

namespace galilean::monitor {
namespace {

constexpr const char* kCheck =
    "check that robots run, and in the same DDS domain (--domain or ROS_DOMAIN_ID)";

bool is_heard_by_operators(const Channel& channel) {
  const auto type = channel.schema->ros_type;
  return type == msg::RobotState::kRosType || type == msg::Program::kRosType ||
         type == msg::Breaks::kRosType || type == msg::ObjectMap::kRosType ||
         type == msg::LeaseChange::kRosType;
}

}  // namespace

void add_addressees(CommandLine& line, Addressees& whom) {
  auto robots = line.option("--robot", whom.robots, "The robots to command").not_empty();
  const auto team = line.flag("--team", whom.team, "Command every robot that sends its state");
  add_domain_option(line, whom.domain);
  robots.excludes(team);
}

Result<void> check_named(const Addressees& whom) {
  if (whom.team || !whom.robots.empty()) return {};
  return Error{"Name the robots with --team or --robot NAME."};
}

Result<std::unique_ptr<OrderSession>> OrderSession::join(const std::string& name, int domain) {
  auto listener = TeamListener::join(name, domain, is_heard_by_operators);
  if (!listener) return listener.error();
  return std::unique_ptr<OrderSession>(new OrderSession(std::move(listener).value()));
}

OrderSession::OrderSession(std::unique_ptr<TeamListener> listener)
    : listener_(std::move(listener)),
      endpoints_(std::make_unique<wire::Endpoints>(listener_->participant())),
      joined_(listener_->now()) {
  listener_->on_message([this](const Message& message) { note(message); });
}

void OrderSession::note(const Message& message) {
  const auto type = message.channel.schema->ros_type;
  has_heard_monitor_ |= type == msg::ObjectMap::kRosType && !message.replayed;
  if (msg::Breaks breaks; type == msg::Breaks::kRosType && msg::decode_cdr(*message.cdr, breaks))
    breaks_[breaks.robot] = std::move(breaks);
  if (msg::LeaseChange change; type == msg::LeaseChange::kRosType && !message.replayed &&
                               msg::decode_cdr(*message.cdr, change))
    holders_[change.robot] = change.holder;
}

Result<void> OrderSession::check_leases(const Addressees& whom) {
  for (const auto& robot : addressed(whom)) {
    const auto holder = holders_.find(robot);
    if (holder == holders_.end() || holder->second.empty() || holder->second == user_name())
      continue;
    const std::string name = visible(robot);
    return Error{"nothing was ordered: " + visible(holder->second) + " steers " + name +
                 " through the monitor; 'galilean lease ask --robot " + name +
                 "' asks for it, and 'galilean lease take' takes it over"};
  }
  return {};
}

Result<std::size_t> OrderSession::find(const Addressees& whom, Duration others_within) {
  constexpr Duration kGather = std::chrono::milliseconds(300);
  const auto there = [this](const std::string& robot) { return is_there(robot); };
  const bool any = wait(kHear, [&] { return std::ranges::any_of(addressed(whom), there); });
  if (any && !whom.robots.empty())
    wait(others_within, [&] { return std::ranges::all_of(whom.robots, there); });
  wait(kGather, [] { return false; });
  const auto robots = addressed(whom);
  if (const auto count = std::ranges::count_if(robots, there); count > 0)
    return static_cast<std::size_t>(count);
  if (robots.empty()) return Error{std::string("no robot sends its state; ") + kCheck};
  std::string why;
  for (const auto& robot : robots)
    why += (why.empty() ? "" : "; ") + visible(robot) + " " + silence_of(robot);
  return Error{why + "; " + kCheck};
}

std::vector<std::string> OrderSession::everyone(const Addressees& whom) {
  constexpr Duration kMonitorTellsWithin = std::chrono::seconds(1);
  if (whom.robots.empty())
    wait(std::max(joined_ + kMonitorTellsWithin - now(), Duration{}),
         [this] { return has_heard_monitor_; });
  return addressed(whom);
}

std::vector<std::string> OrderSession::wait_for_answers(const std::vector<std::string>& robots,
                                                        const std::string& order_id) {
  std::vector<std::string> waiting = robots;
  wait(kAnswer, [&] {
    std::erase_if(waiting,
                  [&](const std::string& robot) { return answer_of(robot, order_id) != nullptr; });
    return waiting.empty();
  });
  return waiting;
}

bool OrderSession::is_there(const std::string& robot) const {
  const Team& team = listener_->team();
  const Robot* found = team.find(robot);
  return found && found->state && !team.silent(*found) && !team.replayed(*found);
}

bool OrderSession::has_told_since(const std::string& robot, Time since) const {
  const Team& team = listener_->team();
  const Robot* found = team.find(robot);
  return found && found->state && found->state_received > since && !team.replayed(*found);
}

std::string OrderSession::silence_of(const std::string& robot) const {
  const Team& team = listener_->team();
  const Robot* found = team.find(robot);
  if (!found) return "sends no state";
  if (team.replayed(*found)) return "is played by a recording, and is not there";
  const long silent_s = std::max(std::lround(team.age_s(*found)), 1L);
  return "has sent nothing for " + std::to_string(silent_s) + " s, so it is not known what it does";
}

const msg::RobotState* OrderSession::state_of(const std::string& robot) const {
  const Robot* found = listener_->team().find(robot);
  return found && found->state ? &*found->state : nullptr;
}

const msg::Program* OrderSession::program_of(const std::string& robot) const {
  const Robot* found = listener_->team().find(robot);
  return found && found->program ? &*found->program : nullptr;
}

const msg::Breaks* OrderSession::breaks_of(const std::string& robot) const {
  const auto found = breaks_.find(robot);
  return found == breaks_.end() ? nullptr : &found->second;
}

const msg::BreakAnswer* OrderSession::answer_of(const std::string& robot,
                                                const std::string& order_id) const {
  const msg::Breaks* told = breaks_of(robot);
  return told ? answer_to(*told, order_id) : nullptr;
}

std::vector<std::string> OrderSession::addressed(const Addressees& whom) {
  if (!whom.robots.empty()) return whom.robots;
  const Team& team = listener_->team();
  const auto writing = wire::robots_in(endpoints_->known()).live;
  std::set<std::string> names(writing.begin(), writing.end());
  for (const auto& [name, robot] : team.robots()) names.insert(name);
  std::erase_if(names, [&](const std::string& name) {
    const Robot* robot = team.find(name);
    return robot && team.replayed(*robot);
  });
  return {names.begin(), names.end()};
}

}  // namespace galilean::monitor
