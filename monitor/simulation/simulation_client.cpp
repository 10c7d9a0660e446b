// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/simulation/simulation_client.h"

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "core/wire/topic_names.h"

namespace galilean::monitor {
namespace {

constexpr Duration kLookEach = std::chrono::milliseconds(20);
constexpr Duration kGather = std::chrono::milliseconds(500);
constexpr Duration kSendEach = std::chrono::milliseconds(250);
constexpr int kStatesKept = 64;  // one topic carries the states of several simulations

}  // namespace

SimulationClient::SimulationClient(wire::Participant& participant)
    : states_(participant, wire::kSimulationStateTopic, msg::SimulationState::kRosType,
              kStatesKept),
      events_(participant, wire::kSimulationEventTopic, msg::SimulationEvent::kRosType),
      orders_(participant, wire::kSimulationOrderTopic) {}

bool SimulationClient::wait(Duration most, const std::function<bool()>& enough) {
  for (const Time start = clock_.now(); clock_.now() - start < most;) {
    if (enough()) return true;
    std::this_thread::sleep_for(kLookEach);
  }
  return enough();
}

void SimulationClient::listen() {
  states_.take([this](const wire::Received& received) {
    msg::SimulationState state;
    if (msg::decode_cdr(received.cdr, state)) simulations_.note(std::move(state), clock_.now());
  });
}

Result<msg::SimulationState> SimulationClient::find(const std::string& name, Duration patience) {
  const auto heard = [&] {
    listen();
    return name.empty() ? simulations_.count() > 0 : simulations_.find(name, clock_.now()).ok();
  };
  // Without a name, further simulations may be heard a little later.
  if (wait(patience, heard) && name.empty())
    wait(kGather, [this] {
      listen();
      return false;
    });
  const auto found = simulations_.find(name, clock_.now());
  if (!found) return found.error();
  return *found.value();
}

Result<msg::SimulationEvent> SimulationClient::send(const msg::SimulationOrder& order,
                                                    Duration patience) {
  std::optional<msg::SimulationEvent> answer;
  const auto answered = [&] {
    events_.take([&](const wire::Received& received) {
      msg::SimulationEvent event;
      if (msg::decode_cdr(received.cdr, event) && event.order_id == order.id) answer = event;
    });
    return answer.has_value();
  };
  // Whether the simulation hears this writer yet cannot be known, so that the order is sent again.
  // A simulation takes an id once.
  for (const Time start = clock_.now(); !answer && clock_.now() - start < patience;) {
    (void)orders_.write(order);
    wait(kSendEach, answered);
  }
  if (answer) return *answer;
  return Error{"simulation '" + order.simulation + "' does not answer; it may be ending"};
}

}  // namespace galilean::monitor
