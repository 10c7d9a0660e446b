// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/writer.h"

namespace galilean::sim {

/// Takes instructors' orders to one simulation off the wire. An order that is sent again, under the
/// same id, is taken once. It publishes their events and the
/// simulation's state. A thread of its own writes to the wire and to the log, because a write may
/// block and the world must not.
class OrderDesk {
 public:
  /// Only orders to the simulation of this name are taken.
  OrderDesk(wire::Participant& participant, std::string simulation);
  ~OrderDesk();
  OrderDesk(const OrderDesk&) = delete;
  OrderDesk& operator=(const OrderDesk&) = delete;

  /// Returns the orders that came since the last call, in the order in which they came. Does not
  /// wait for the network.
  [[nodiscard]] std::vector<msg::SimulationOrder> take();
  /// Publishes an event and logs it. Its stamp, number and simulation are set here.
  void tell(msg::SimulationEvent event);
  /// Publishes the state as soon as the network takes it. Its stamp and simulation are set here.
  void show(msg::SimulationState state);

 private:
  void receive();
  /// Tells that the order is not taken.
  void refuse(const msg::SimulationOrder& order, const char* why);
  [[nodiscard]] bool is_new(const std::string& id);
  void run();

  std::string simulation_;
  wire::Writer<msg::SimulationEvent> events_;
  wire::Writer<msg::SimulationState> states_;
  std::mutex incoming_mutex_;
  std::vector<msg::SimulationOrder> incoming_;
  std::deque<std::string> known_ids_;  ///< of the newest orders
  std::atomic<bool> has_orders_{false};
  std::mutex outgoing_mutex_;
  std::condition_variable changed_;
  std::deque<msg::SimulationEvent> outgoing_;
  std::optional<msg::SimulationState> newest_;
  bool ending_ = false;
  std::uint64_t told_ = 0;
  wire::Reader orders_;
  std::thread thread_;
};

}  // namespace galilean::sim
