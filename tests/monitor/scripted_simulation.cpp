// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/scripted_simulation.h"

#include <algorithm>
#include <utility>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor {

ScriptedSimulation::ScriptedSimulation(std::string name, int domain)
    : name_(std::move(name)),
      participant_(wire::Participant::join("scripted-" + name_, domain).value()),
      states_(*participant_, wire::kSimulationStateTopic),
      events_(*participant_, wire::kSimulationEventTopic),
      orders_(*participant_, wire::kSimulationOrderTopic, msg::SimulationOrder::kRosType),
      thread_([this] { run(); }) {}

ScriptedSimulation::~ScriptedSimulation() {
  ending_ = true;
  thread_.join();
}

std::vector<msg::SimulationOrder> ScriptedSimulation::heard() const {
  const std::lock_guard lock(mutex_);
  return heard_;
}

void ScriptedSimulation::run() {
  constexpr int kLooksAState = 10;
  for (int look = 0; !ending_; ++look) {
    if (look % kLooksAState == 0) {
      msg::SimulationState state;
      state.stamp = wire::ros_time(wire::wall_clock_ns());
      state.simulation = name_;
      (void)states_.write(state);
    }
    orders_.take([this](const wire::Received& received) {
      msg::SimulationOrder order;
      if (msg::decode_cdr(received.cdr, order) && order.simulation == name_) take(order);
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

void ScriptedSimulation::take(const msg::SimulationOrder& order) {
  const std::lock_guard lock(mutex_);
  const bool is_new = std::ranges::none_of(
      heard_, [&](const msg::SimulationOrder& each) { return each.id == order.id; });
  heard_.push_back(order);
  if (!is_new || !answers_) return;
  msg::SimulationEvent event;
  event.simulation = name_;
  event.order_id = order.id;
  event.author = order.author;
  event.order = order.order;
  event.subject = order.subject;
  event.done = order.order != "remove";
  event.text = event.done ? order.order + " is done" : "nothing is removed here";
  (void)events_.write(event);
}

}  // namespace galilean::monitor
