// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/order_session.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include "core/command_line/domain_option.h"
#include "core/visible_text.h"
#include "monitor/orders/break_answer.h"

namespace galilean::monitor {
namespace {

constexpr const char* kCheck =
    "check that robots run, and in the same DDS domain (--domain or ROS_DOMAIN_ID)";

bool is_heard_by_operators(const Channel& channel) {
  const auto type = channel.schema->ros_type;
  return type == msg::RobotState::kRosType || type == msg::Program::kRosType ||
         type == msg::Breaks::kRosType || type == msg::ObjectMap::kRosType;
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
    : listener_(std::move(listener)) {
  listener_->on_message([this](const Message& message) {
    msg::Breaks breaks;
    if (message.channel.schema->ros_type != msg::Breaks::kRosType) return;
    if (msg::decode_cdr(*message.cdr, breaks)) breaks_[breaks.robot] = std::move(breaks);
  });
}

Result<std::vector<std::string>> OrderSession::find(const Addressees& whom) {
  constexpr Duration kGather = std::chrono::milliseconds(300);
  wait(kHear, [&] {
    const auto heard = [this](const std::string& robot) { return state_of(robot) != nullptr; };
    return !speaking().empty() && std::ranges::all_of(whom.robots, heard);
  });
  wait(kGather, [] { return false; });
  const auto names = whom.robots.empty() ? speaking() : whom.robots;
  for (const auto& robot : names)
    if (!state_of(robot)) return Error{visible(robot) + " sends no state; " + kCheck};
  if (names.empty()) return Error{std::string("no robot sends its state; ") + kCheck};
  return names;
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

bool OrderSession::tell_silent(const std::vector<std::string>& told) const {
  const Team& team = listener_->team();
  bool any = false;
  for (const auto& [name, robot] : team.robots()) {
    if (!team.silent(robot) || std::ranges::find(told, name) != told.end()) continue;
    std::cout << visible(name) << ": has sent nothing for " << std::lround(team.age_s(robot))
              << " s, so it is not known what it does\n";
    any = true;
  }
  return any;
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

std::vector<std::string> OrderSession::speaking() const {
  const Team& team = listener_->team();
  std::vector<std::string> names;
  for (const auto& [name, robot] : team.robots())
    if (robot.state && !team.silent(robot)) names.push_back(name);
  return names;
}

}  // namespace galilean::monitor
