// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/order_log.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "core/wire/topic_names.h"
#include "monitor/background/guarded.h"
#include "monitor/pushes/order_words.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kMostRemembered = 256;
constexpr auto kLookEach = std::chrono::milliseconds(100);

void log_lost_order(const std::string& why) {
  std::clog << "galilean-monitor: an order was not kept: " << why << std::endl;
}

/// Returns how many rows the history gets for an order: one for itself and one for each robot, and
/// as many more as its texts are long.
std::size_t rows_for(const OrderRecord& order, std::size_t robots) {
  constexpr std::size_t kRowBytes = 4096;
  std::size_t bytes =
      order.id.size() + order.author.size() + order.kind.size() + order.detail.size();
  for (const auto& target : order.targets) bytes += target.size();
  return 1 + (order.targets.empty() ? robots : order.targets.size()) + bytes / kRowBytes;
}

}  // namespace

OrderLog::OrderLog(const Parts& parts) : parts_(parts), timer_(parts.io) {
  watch();
}

void OrderLog::expect(const std::string& id) {
  own_.push_back(id);
  if (own_.size() > kMostRemembered) own_.pop_front();
}

bool OrderLog::is_own(const std::string& id) const {
  return std::ranges::find(own_, id) != own_.end();
}

void OrderLog::note(const msg::Command& command, const Kept& kept) {
  keep({.order = record_of(command), .topic = wire::kCommandTopic, .command = command.kind}, kept);
}

void OrderLog::note(const msg::BreakOrder& order, const Kept& kept) {
  keep({.order = record_of(order), .topic = wire::kBreakOrderTopic}, kept);
}

void OrderLog::note(const msg::ProgramRollback& order, const Kept& kept) {
  keep({.order = record_of(order), .topic = wire::kProgramRollbackTopic}, kept);
}

void OrderLog::note(const msg::SimulationOrder& order, const Kept& kept) {
  keep({.order = record_of(order), .topic = wire::kSimulationOrderTopic, .is_to_robots = false},
       kept);
}

void OrderLog::note_refused(const msg::Command& command, const std::vector<std::string>& robots,
                            const std::string& why) {
  keep_refused({.order = record_of(command), .topic = wire::kCommandTopic}, robots, why);
}

void OrderLog::note_refused(const msg::BreakOrder& order, const std::vector<std::string>& robots,
                            const std::string& why) {
  keep_refused({.order = record_of(order), .topic = wire::kBreakOrderTopic}, robots, why);
}

void OrderLog::keep_refused(const Given& given, const std::vector<std::string>& robots,
                            const std::string& why) {
  if (!has_room_for(given))
    return parts_.refusals.note(
        given.topic,
        "more orders that are refused than anybody gives by hand are not kept in the history");
  parts_.worker.run([this, order = given.order, robots, why] {
    auto kept = parts_.history.add_order(order);
    for (const auto& robot : robots)
      if (kept)
        kept = parts_.history.add_outcome(
            order.id, {.of = robot, .outcome = "refused: " + why, .told_ns = 0});
    if (!kept) log_lost_order(kept.error().message);
  });
}

void OrderLog::keep(const Given& given, const Kept& kept) {
  const bool is_known = std::ranges::find(newest_, given.order.id) != newest_.end();
  if (!is_known && !kept && !is_own(given.order.id) && !has_room_for(given))
    return parts_.refusals.note(given.topic,
                                "more orders than others give by hand are not kept in the history");
  const auto waiting = std::make_shared<Kept>(kept);
  if (kept) waiting_.push_back({parts_.clock.now(), waiting});
  const auto done = [waiting](const Result<void>& outcome) {
    if (!outcome) log_lost_order(outcome.error().message);
    if (const auto tell = std::exchange(*waiting, nullptr)) tell(outcome);
  };
  const auto failed = [done](const std::string& why) { done(Error{why}); };
  // The history keeps it once. Whoever waits is told whether it is there.
  const auto add = [this, order = given.order] { return parts_.history.add_order(order); };
  if (kept)
    parts_.worker.run_first(add, done, failed);
  else if (!is_known)
    parts_.worker.run(add, done, failed);
  if (is_known) return;
  newest_.push_back(given.order.id);
  if (newest_.size() > kMostRemembered) newest_.pop_front();
  expect_outcomes(given);
}

// Each row waits for the disk. The monitor must not be held by a flood of them, nor at its end, and
// a stranger must not fill the disk.
bool OrderLog::has_room_for(const Given& given) {
  constexpr std::size_t kMostRows = 200;
  constexpr Duration kWithin = std::chrono::seconds(10);
  const Time now = parts_.clock.now();
  while (!others_.empty() && now - others_.front().first > kWithin) {
    rows_of_others_ -= others_.front().second;
    others_.pop_front();
  }
  const std::size_t rows =
      rows_for(given.order, given.is_to_robots ? parts_.team.robots().size() : 0);
  if (rows_of_others_ + rows > kMostRows) return false;
  others_.emplace_back(now, rows);
  rows_of_others_ += rows;
  return true;
}

void OrderLog::expect_outcomes(const Given& given) {
  const auto& targets = given.order.targets;
  Open open{
      .id = given.order.id, .command = given.command, .since = parts_.clock.now(), .waiting = {}};
  for (const auto& target : targets) open.waiting[target];
  for (const auto& [name, robot] : parts_.team.robots()) {
    const bool is_addressed =
        targets.empty() ? !parts_.team.replayed(robot) : open.waiting.contains(name);
    if (given.is_to_robots && is_addressed)
      open.waiting[name] = robot.state.value_or(msg::RobotState());
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
    answer_late(now);
  });
  timer_.expires_after(kLookEach);
  timer_.async_wait([this](boost::system::error_code error) {
    if (!error) watch();
  });
}

void OrderLog::answer_late(Time now) {
  while (!waiting_.empty()) {
    const auto [since, kept] = waiting_.front();
    if (*kept && now - since < kDiskPatience) return;
    waiting_.pop_front();
    if (const auto tell = std::exchange(*kept, nullptr))
      tell(Error{"the disk has not answered yet; it is kept when the disk does"});
  }
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
