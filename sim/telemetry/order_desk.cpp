// SPDX-License-Identifier: BSD-3-Clause
#include "sim/telemetry/order_desk.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "core/failure.h"
#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"

namespace galilean::sim {
namespace {

constexpr std::size_t kIdsKept = 256;
/// The world takes all that wait before its next step, in 10 ms. Only a flood is more.
constexpr std::size_t kMostWaiting = 256;

std::string log_line(const msg::SimulationEvent& event) {
  const std::string who = "galilean-sim: " + visible(event.author);
  return event.done
             ? who + " " + visible(event.text)
             : who + "'s order '" + visible(event.order) + "' was refused: " + visible(event.text);
}

}  // namespace

OrderDesk::OrderDesk(wire::Participant& participant, std::string simulation)
    : simulation_(std::move(simulation)),
      events_(participant, wire::kSimulationEventTopic),
      states_(participant, wire::kSimulationStateTopic),
      orders_(participant, wire::kSimulationOrderTopic, msg::SimulationOrder::kRosType),
      thread_([this] { run(); }) {
  // A thread of DDS calls this function. An exception from it would end the process.
  orders_.on_data([this] { static_cast<void>(attempt([this] { receive(); })); });
  receive();
}

OrderDesk::~OrderDesk() {
  {
    const std::lock_guard lock(outgoing_mutex_);
    ending_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void OrderDesk::receive() {
  const std::lock_guard lock(incoming_mutex_);
  orders_.take([this](const wire::Received& received) {
    msg::SimulationOrder order;
    if (!msg::decode_cdr(received.cdr, order) || order.simulation != simulation_) return;
    if (order.id.empty()) return refuse(order, "it has no id");
    if (!is_new(order.id)) return;
    if (incoming_.size() >= kMostWaiting) return refuse(order, "too many orders wait");
    incoming_.push_back(std::move(order));
    has_orders_ = true;
  });
}

void OrderDesk::refuse(const msg::SimulationOrder& order, const char* why) {
  msg::SimulationEvent event;
  event.order_id = order.id;
  event.author = order.author;
  event.order = order.order;
  event.subject = order.subject;
  event.text = why;
  tell(std::move(event));
}

bool OrderDesk::is_new(const std::string& id) {
  if (std::ranges::find(known_ids_, id) != known_ids_.end()) return false;
  known_ids_.push_back(id);
  if (known_ids_.size() > kIdsKept) known_ids_.pop_front();
  return true;
}

std::vector<msg::SimulationOrder> OrderDesk::take() {
  if (!has_orders_.exchange(false)) return {};
  const std::lock_guard lock(incoming_mutex_);
  return std::exchange(incoming_, {});
}

void OrderDesk::tell(msg::SimulationEvent event) {
  event.stamp = wire::ros_time(wire::wall_clock_ns());
  event.simulation = simulation_;
  {
    const std::lock_guard lock(outgoing_mutex_);
    event.number = ++told_;
    outgoing_.push_back(std::move(event));
  }
  changed_.notify_one();
}

void OrderDesk::show(msg::SimulationState state) {
  state.stamp = wire::ros_time(wire::wall_clock_ns());
  state.simulation = simulation_;
  {
    const std::lock_guard lock(outgoing_mutex_);
    newest_ = std::move(state);
  }
  changed_.notify_one();
}

void OrderDesk::run() {
  std::unique_lock lock(outgoing_mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ending_ || newest_ || !outgoing_.empty(); });
    if (ending_) return;
    const auto events = std::exchange(outgoing_, {});
    const auto state = std::exchange(newest_, std::nullopt);
    lock.unlock();
    // If Cyclone does not take a state in time, the next one follows within a tenth of a second.
    if (state) (void)states_.write(*state);
    for (const auto& event : events) {
      if (!events_.write(event))
        std::cerr << "galilean-sim: DDS did not take the answer to an order\n";
      std::cerr << log_line(event) << std::endl;
    }
    lock.lock();
  }
}

}  // namespace galilean::sim
