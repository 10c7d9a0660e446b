// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "monitor/background/worker.h"
#include "monitor/pushes/history/history.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Keeps every order that is no push in the history, whoever gives it: who gave it, when, to whom,
/// and what each robot made of it. A robot that tells nothing within kPatience is kept with that.
///
/// Lives on the io_context's thread.
class OrderLog {
 public:
  static constexpr Duration kPatience = std::chrono::seconds(2);

  struct Parts {
    boost::asio::io_context& io;
    Worker& worker;
    const Team& team;
    History& history;  ///< only the worker's thread uses it
    const Clock& clock;
  };
  /// `kept` is an error if the disk could not be written.
  using Kept = std::function<void(const Result<void>& kept)>;

  explicit OrderLog(const Parts& parts);

  /// Takes in an order that was given. An order that comes twice is kept once; `kept` is called in
  /// any case, on the io_context's thread.
  void note(const msg::Command& command, const Kept& kept = {});
  void note(const msg::BreakOrder& order, const Kept& kept = {});
  void note(const msg::ProgramRollback& order, const Kept& kept = {});
  void note(const msg::SimulationOrder& order, const Kept& kept = {});

  /// Takes in what may tell of an order.
  void note(const msg::Breaks& breaks);
  void note(const msg::ProgramReply& reply);
  void note(const msg::SimulationEvent& event);

 private:
  struct Open {
    std::string id;
    std::uint8_t command = 0;                        ///< msg::Command::kind; 0: another order
    Time since{};                                    ///< when it came
    std::map<std::string, msg::RobotState> waiting;  ///< who has not told, as it was then
  };

  void keep(const OrderRecord& order, std::uint8_t command, bool is_to_robots, const Kept& kept);
  /// Keeps what became of the order at `of`, if it is waited for.
  void tell(const std::string& order_id, const std::string& of, const std::string& outcome);
  void watch();
  void see(Open& open, Time now);

  Parts parts_;
  std::deque<Open> open_;
  std::deque<std::string> newest_;  ///< the ids of the newest orders
  boost::asio::steady_timer timer_;
};

}  // namespace galilean::monitor
