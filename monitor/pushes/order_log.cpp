// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/order_log.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "monitor/background/guarded.h"
#include "monitor/pushes/order_words.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kMostRemembered = 256;
constexpr auto kLookEach = std::chrono::milliseconds(100);

void log_lost_order(const std::string& why) {
  std::clog << "galilean-monitor: an order was not kept: " << why << std::endl;
}

}  // namespace

OrderLog::OrderLog(const Parts& parts) : parts_(parts), timer_(parts.io) {
  watch();
}

void OrderLog::note(const msg::Command& command, const Kept& kept) {
  keep(record_of(command), command.kind, true, kept);
}

void OrderLog::note(const msg::BreakOrder& order, const Kept& kept) {
  keep(record_of(order), 0, true, kept);
}

void OrderLog::note(const msg::ProgramRollback& order, const Kept& kept) {
  keep(record_of(order), 0, true, kept);
}

void OrderLog::note(const msg::SimulationOrder& order, const Kept& kept) {
  keep(record_of(order), 0, false, kept);
}

void OrderLog::keep(const OrderRecord& order, std::uint8_t command, bool is_to_robots,
                    const Kept& kept) {
  const bool is_known = std::ranges::find(newest_, order.id) != newest_.end();
  const auto done = [kept](const Result<void>& outcome) {
    if (!outcome) log_lost_order(outcome.error().message);
    if (kept) kept(outcome);
  };
  const auto failed = [done](const std::string& why) { done(Error{why}); };
  // The history keeps it once. Whoever waits is told whether it is there.
  if (!is_known || kept)
    parts_.worker.run([this, order] { return parts_.history.add_order(order); }, done, failed);
  if (is_known) return;
  newest_.push_back(order.id);
  if (newest_.size() > kMostRemembered) newest_.pop_front();

  Open open{.id = order.id, .command = command, .since = parts_.clock.now(), .waiting = {}};
  for (const auto& target : order.targets) open.waiting[target];
  for (const auto& [name, robot] : parts_.team.robots()) {
    const bool is_addressed =
        order.targets.empty() ? !parts_.team.replayed(robot) : open.waiting.contains(name);
    if (is_to_robots && is_addressed) open.waiting[name] = robot.state.value_or(msg::RobotState());
  }
  open_.push_back(std::move(open));
}

void OrderLog::tell(const std::string& order_id, const std::string& of,
                    const std::string& outcome) {
  const auto open = std::ranges::find(open_, order_id, &Open::id);
  if (open == open_.end() || open->waiting.erase(of) == 0) return;
  parts_.worker.run([this, order_id, of, outcome] {
    const auto kept =
        parts_.history.add_outcome(order_id, {.of = of, .outcome = outcome, .told_ns = 0});
    if (!kept) log_lost_order(kept.error().message);
  });
}

void OrderLog::note(const msg::Breaks& breaks) {
  for (const auto& answer : breaks.answers) tell(answer.id, breaks.robot, outcome_of(answer));
}

void OrderLog::note(const msg::ProgramReply& reply) {
  tell(reply.id, reply.robot, outcome_of(reply));
}

void OrderLog::note(const msg::SimulationEvent& event) {
  tell(event.order_id, event.simulation, outcome_of(event));
}

void OrderLog::watch() {
  (void)guarded("watching orders", [this] {
    const Time now = parts_.clock.now();
    for (auto& open : open_) see(open, now);
    std::erase_if(open_, [](const Open& open) { return open.waiting.empty(); });
  });
  timer_.expires_after(kLookEach);
  timer_.async_wait([this](boost::system::error_code error) {
    if (!error) watch();
  });
}

void OrderLog::see(Open& open, Time now) {
  const bool is_over = now - open.since >= kPatience;
  for (const auto& [name, before] : std::map(open.waiting)) {
    const Robot* robot = parts_.team.find(name);
    const bool has_told = robot && robot->state && robot->state_received > open.since;
    const auto outcome =
        has_told && open.command != 0 ? obedience(open.command, before, *robot->state) : "";
    if (!outcome.empty())
      tell(open.id, name, outcome);
    else if (is_over)
      tell(open.id, name, has_told ? "did not confirm it within 2 s" : "was silent for 2 s");
  }
}

}  // namespace galilean::monitor
