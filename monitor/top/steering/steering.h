// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "monitor/orders/operator.h"
#include "monitor/top/model/dashboard_model.h"
#include "monitor/top/model/stop_order.h"
#include "monitor/top/steering/answers.h"
#include "monitor/top/steering/notice_board.h"

namespace galilean::monitor::top {

/// How orders reach robots. No robots' names mean all robots.
struct Voice {
  // Both return the order's id, which comes back in the robots' answers, or an empty string if it
  // could not be sent.
  std::function<std::string(Operator::Word, const std::vector<std::string>& robots)> say;
  std::function<std::string(const msg::BreakOrder&)> order_breaks;
};

/// Gives orders to robots, and tells the operator what became of them.
class Steering {
 public:
  /// Returns whether this operator may steer the robot, or all robots. It has told why not.
  using MaySteer = std::function<bool(const std::string& robot, bool all)>;

  /// Requires: what is passed as a reference outlives this.
  Steering(const DashboardModel& model, const Clock& clock, Voice voice, NoticeBoard& notices);

  /// Has every order that does more than stop asked about first.
  void ask_before_orders(MaySteer may_steer) { may_steer_ = std::move(may_steer); }
  /// Tells again those that have not confirmed the order to stop, and tells the operator of
  /// answers. Call it some times a second.
  void update();
  void stop_all();
  /// Tells one robot a word, or all. `robot` is empty if none is heard.
  void say(Operator::Word word, const std::string& robot, bool to_all);
  /// Gives a robot an order about break points: "set", "remove", "clear" or "let_through".
  void order_breaks(const std::string& robot, const std::string& order,
                    std::vector<msg::BreakPoint> points);

  /// Returns who has confirmed the order to stop all; empty while there is none.
  [[nodiscard]] std::string stop_report() const;
  void end_stop_report() { stop_order_.reset(); }

 private:
  void tell_stop_again();
  void expect_answers(Operator::Word word, const std::string& id, std::vector<std::string> robots);
  /// Returns the robots that are heard and that no recording plays.
  [[nodiscard]] std::vector<std::string> heard() const;
  /// Takes those that are resumed out of the order to stop.
  void end_stop_of(const std::string& robot, bool of_all);

  const DashboardModel& model_;
  const Clock& clock_;
  const Voice voice_;
  MaySteer may_steer_ = [](const std::string&, bool) { return true; };
  NoticeBoard& notices_;
  Answers answers_;
  std::optional<StopOrder> stop_order_;
  Time stop_told_{};
  std::optional<Time> all_stopped_;
};

}  // namespace galilean::monitor::top
