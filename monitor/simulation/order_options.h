// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/command_line/command_line.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// The commands of `galilean sim ctl`, one for each order to a simulation.
class OrderOptions {
 public:
  /// Requires: this lives until `app` was parsed.
  explicit OrderOptions(CommandLine& app);
  OrderOptions(const OrderOptions&) = delete;
  OrderOptions& operator=(const OrderOptions&) = delete;

  /// Returns the order that was given, or nothing if `truth` was. Id, author, stamp and simulation
  /// are left to the caller. Requires: the command line was parsed.
  [[nodiscard]] std::optional<msg::SimulationOrder> order() const;

 private:
  CommandLine& add(CommandLine& app, const char* order, const char* name, const char* help);
  void add_clock(CommandLine& app);
  void add_bodies(CommandLine& app);
  void add_parts(CommandLine& app);

  struct Command {
    std::string order;  ///< on the wire; empty: `truth`
    CommandLine line;
  };
  std::deque<Command> commands_;
  msg::SimulationOrder read_;
  std::string contest_;
  std::optional<double> heading_deg_;
  double direction_deg_ = 0;
  bool stuck_ = false;
};

}  // namespace galilean::monitor
