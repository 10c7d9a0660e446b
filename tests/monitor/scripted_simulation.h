// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/writer.h"

namespace galilean::monitor {

/// A live simulation as it appears on DDS, without a world behind it. It publishes a state ten
/// times a second, and answers each order once: it does all but `remove`, which it refuses.
class ScriptedSimulation {
 public:
  ScriptedSimulation(std::string name, int domain);
  ~ScriptedSimulation();

  /// From now on it answers no order.
  void ignore_orders() { answers_ = false; }
  /// Returns the orders that it heard, each as often as it was sent.
  [[nodiscard]] std::vector<msg::SimulationOrder> heard() const;

 private:
  void run();
  void take(const msg::SimulationOrder& order);

  std::string name_;
  std::unique_ptr<wire::Participant> participant_;
  wire::Writer<msg::SimulationState> states_;
  wire::Writer<msg::SimulationEvent> events_;
  wire::Reader orders_;
  std::atomic<bool> answers_{true};
  std::atomic<bool> ending_{false};
  mutable std::mutex mutex_;
  std::vector<msg::SimulationOrder> heard_;
  std::thread thread_;
};

}  // namespace galilean::monitor
