// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/simulation/simulation_desk.h"

#include <algorithm>
#include <utility>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor {
namespace {

/// Returns an id that no other process gives, and this one gives once.
std::string order_id(std::int64_t now_ns) {
  static int count = 0;
  return "monitor-" + std::to_string(now_ns) + "-" + std::to_string(++count);
}

}  // namespace

SimulationDesk::SimulationDesk(boost::asio::io_context& io, Worker& worker, const Clock& clock,
                               wire::Participant& participant)
    : worker_(worker),
      clock_(clock),
      orders_(participant, wire::kSimulationOrderTopic),
      timer_(io) {}

void SimulationDesk::order(msg::SimulationOrder order, Finish finish) {
  using Reason = UnansweredOrder::Reason;
  const Time now = clock_.now();
  const auto found = simulations_.find(order.simulation, now);
  if (!found) return finish(UnansweredOrder{Reason::kNoSimulation, found.error().message});
  const std::int64_t now_ns = wire::wall_clock_ns();
  order.stamp = wire::ros_time(now_ns);
  order.id = order_id(now_ns);
  order.simulation = found.value()->simulation;
  const auto open = std::make_shared<Open>(
      Open{.order = std::move(order), .finish = std::move(finish), .sent = now});
  open_.push_back(open);
  send(open);
  if (open_.size() == 1) watch();
}

void SimulationDesk::send(const OpenPtr& open) {
  if (std::exchange(open->is_being_written, true)) return;
  // If DDS does not take the order in time, the next round sends it again.
  worker_.run([this, order = open->order] { return orders_.write(order); },
              [open](bool /*taken*/) { open->is_being_written = false; },
              [this, open](const std::string& why) {
                close(open, UnansweredOrder{UnansweredOrder::Reason::kUnable, why});
              });
}

void SimulationDesk::note(msg::SimulationState state) {
  simulations_.note(std::move(state), clock_.now());
}

void SimulationDesk::note(const msg::SimulationEvent& event) {
  const auto open = std::ranges::find_if(
      open_, [&](const OpenPtr& each) { return each->order.id == event.order_id; });
  if (open != open_.end()) close(*open, event);
}

// `open` is by value because it may be the list's own.
void SimulationDesk::close(OpenPtr open, const Answer& answer) {
  if (std::erase(open_, open) > 0) open->finish(answer);
}

void SimulationDesk::watch() {
  timer_.expires_after(kSendEach);
  timer_.async_wait([this](boost::system::error_code error) {
    if (error) return;
    for (const auto& open : std::vector(open_))
      if (clock_.now() - open->sent < kPatience)
        send(open);
      else
        close(open, UnansweredOrder{UnansweredOrder::Reason::kSilent,
                                    "simulation '" + open->order.simulation +
                                        "' does not answer; it may be ending"});
    if (!open_.empty()) watch();
  });
}

}  // namespace galilean::monitor
