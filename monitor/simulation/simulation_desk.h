// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/result.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/background/worker.h"
#include "monitor/simulation/simulations.h"

namespace galilean::monitor {

/// Why an order has no answer from a simulation.
struct UnansweredOrder {
  enum class Reason {
    kNoSimulation,  ///< none is heard, or not the one that is named
    kSilent,        ///< it did not answer in time
    kUnable,        ///< this machine cannot send the order
  };
  Reason reason = Reason::kNoSimulation;
  std::string message;
};

/// Sends instructors' orders to the simulations that are heard, and brings back their answers. A
/// simulation can come later than the monitor, so that an order is sent again until it is answered;
/// a simulation takes an id once.
///
/// Lives on the io_context's thread, and never blocks it: DDS writes happen on the worker's thread.
class SimulationDesk {
 public:
  using Answer = Result<msg::SimulationEvent, UnansweredOrder>;
  using Finish = std::function<void(const Answer&)>;

  /// An order is answered within this time and kSendEach.
  static constexpr Duration kPatience = std::chrono::seconds(5);
  static constexpr Duration kSendEach = std::chrono::milliseconds(250);

  SimulationDesk(boost::asio::io_context& io, Worker& worker, const Clock& clock,
                 wire::Participant& participant);

  /// Sends an order to the simulation that it names, or to the only one if it names none, and calls
  /// `finish` with the simulation's event. Sets the order's id, stamp and simulation.
  void order(msg::SimulationOrder order, Finish finish);

  /// Takes in a message that DDS brought.
  void note(msg::SimulationState state);
  void note(const msg::SimulationEvent& event);

 private:
  struct Open {
    msg::SimulationOrder order;
    Finish finish;
    Time sent;
    bool is_being_written = false;
  };
  using OpenPtr = std::shared_ptr<Open>;

  void send(const OpenPtr& open);
  void close(OpenPtr open, const Answer& answer);
  void watch();

  Worker& worker_;
  const Clock& clock_;
  Simulations simulations_;
  wire::Writer<msg::SimulationOrder> orders_;
  std::vector<OpenPtr> open_;
  boost::asio::steady_timer timer_;
};

}  // namespace galilean::monitor
