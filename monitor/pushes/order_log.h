// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "core/wire/refusals.h"
#include "monitor/background/worker.h"
#include "monitor/pushes/history/history.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Keeps every order that is no push in the history, whoever gives it: who gave it, when, to whom,
/// and what each robot made of it. A robot that tells nothing within kPatience is kept with that. A
/// flood of orders that others give, or that are refused, is not kept, but counted.
///
/// Lives on the io_context's thread.
class OrderLog {
 public:
  static constexpr Duration kPatience = std::chrono::seconds(2);
  /// Whoever gave an order is not kept waiting for longer by a disk that does not answer.
  static constexpr Duration kDiskPatience = std::chrono::seconds(1);

  struct Parts {
    boost::asio::io_context& io;
    Worker& worker;
    const Team& team;
    History& history;  ///< only the worker's thread uses it
    const Clock& clock;
    wire::Refusals& refusals;  ///< counts the orders that are not kept
  };
  /// `kept` is an error if the disk could not be written, or has not answered for kDiskPatience. In
  /// that case the order is kept when the disk answers.
  using Kept = std::function<void(const Result<void>& kept)>;

  explicit OrderLog(const Parts& parts);

  /// Takes in the id of an order that this monitor is about to give. DDS brings the order back
  /// before whoever gave it knows that it was sent.
  void expect(const std::string& id);
  /// Takes in an order that was given. An order that comes twice is kept once; `kept` is called in
  /// any case, on the io_context's thread.
  void note(const msg::Command& command, const Kept& kept = {});
  void note(const msg::BreakOrder& order, const Kept& kept = {});
  void note(const msg::ProgramRollback& order, const Kept& kept = {});
  void note(const msg::SimulationOrder& order, const Kept& kept = {});
  /// Takes in an order that was refused and so not given. `why` is kept as what became of it at
  /// each of `robots`. A flood of them is not kept, but counted.
  void note_refused(const msg::Command& command, const std::vector<std::string>& robots,
                    const std::string& why);
  void note_refused(const msg::BreakOrder& order, const std::vector<std::string>& robots,
                    const std::string& why);

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

  /// An order, and what is known of its kind.
  struct Given {
    OrderRecord order;
    const char* topic;
    std::uint8_t command = 0;  ///< msg::Command::kind; 0: another order
    bool is_to_robots = true;
  };
  void keep(const Given& given, const Kept& kept);
  void keep_refused(const Given& given, const std::vector<std::string>& robots,
                    const std::string& why);
  /// Returns whether another order of others, or a refused one, may be kept now, and notes it.
  [[nodiscard]] bool has_room_for(const Given& given);
  [[nodiscard]] bool is_own(const std::string& id) const;
  /// Waits for what becomes of an order.
  void expect_outcomes(const Given& given);
  /// Keeps what became of the order at `of`, if it is waited for.
  void tell(const std::string& order_id, const std::string& of, const std::string& outcome);
  void watch();
  void answer_late(Time now);
  void see(Open& open, Time now);

  /// Somebody who waits until an order is kept.
  struct Waiting {
    Time since{};
    std::shared_ptr<Kept> kept;  ///< empty once it was called
  };

  Parts parts_;
  std::deque<Open> open_;
  std::deque<Waiting> waiting_;
  std::deque<std::pair<Time, std::size_t>> others_;  ///< the newest of those: when, rows
  std::size_t rows_of_others_ = 0;                   ///< the sum of their rows
  std::deque<std::string> newest_;                   ///< the ids of the newest orders
  std::deque<std::string> own_;                      ///< the ids of the newest that were expected
  boost::asio::steady_timer timer_;
};

}  // namespace galilean::monitor
