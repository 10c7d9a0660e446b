// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/clock.h"
#include "core/result.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/writer.h"
#include "monitor/simulation/simulations.h"

namespace galilean::monitor {

/// A short-lived command's talk with a simulation. For use by one thread.
class SimulationClient {
 public:
  /// Errors: throws std::runtime_error if DDS refuses a topic.
  explicit SimulationClient(wire::Participant& participant);

  /// Returns the state of the simulation of this name, or of the only one if `name` is empty. Waits
  /// for it, at most `patience`. Errors: those of Simulations::find.
  [[nodiscard]] Result<msg::SimulationState> find(const std::string& name, Duration patience);
  /// Sends the order, again and again until it is answered. Errors: no answer came in time.
  [[nodiscard]] Result<msg::SimulationEvent> send(const msg::SimulationOrder& order,
                                                  Duration patience);

 private:
  bool wait(Duration most, const std::function<bool()>& enough);
  void listen();

  SteadyClock clock_;
  Simulations simulations_;
  wire::Reader states_;
  wire::Reader events_;
  wire::Writer<msg::SimulationOrder> orders_;
};

}  // namespace galilean::monitor
