// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/command_line/command_line.h"
#include "core/result.h"
#include "core/wire/endpoints.h"
#include "monitor/commands/team_listener.h"

namespace galilean::monitor {

/// Whom a command gives an order, and in which DDS domain.
struct Addressees {
  std::vector<std::string> robots;
  bool team = false;
  int domain = -1;  ///< as ROS_DOMAIN_ID says, else 0
};

/// Adds --robot, --team and --domain.
void add_addressees(CommandLine& line, Addressees& whom);
/// Errors: neither robots nor the team are named. What changes what robots do must name them, so
/// that a word that was forgotten does not reach the whole team.
[[nodiscard]] Result<void> check_named(const Addressees& whom);

/// One command's talk with robots over DDS: who is there, and what they tell.
class OrderSession {
 public:
  static constexpr Duration kHear = std::chrono::seconds(3);
  static constexpr Duration kAnswer = std::chrono::seconds(2);

  /// `name` is the participant's name, which other participants see. Errors: DDS cannot be used.
  [[nodiscard]] static Result<std::unique_ptr<OrderSession>> join(const std::string& name,
                                                                  int domain);

  /// Waits until the first of the robots has told how it is, for at most kHear, and then for the
  /// other named ones, for at most `others_within`, or for others of the team. Returns how many of
  /// them are there. Errors: none of them is; the error says who is not.
  [[nodiscard]] Result<std::size_t> find(const Addressees& whom, Duration others_within = kHear);
  /// Errors: another operator steers one of the robots through a monitor. An order that does not
  /// stop them is for that operator to give.
  [[nodiscard]] Result<void> check_leases(const Addressees& whom);
  /// Returns the named robots, or all that are known: those that send their state, those whose
  /// writers are known, and those of which a monitor tells. A robot that a recording plays is none
  /// of the team.
  [[nodiscard]] std::vector<std::string> addressed(const Addressees& whom);
  /// As addressed(). For the team it waits until a monitor has told whom it knows, or until one
  /// would have.
  [[nodiscard]] std::vector<std::string> everyone(const Addressees& whom);
  /// Returns whether the robot sends its state now. It is not there if a recording plays it.
  [[nodiscard]] bool is_there(const std::string& robot) const;
  /// Returns whether a state of the robot's own came after `since`. Who has none has not confirmed
  /// an order of then, whatever was known of it before.
  [[nodiscard]] bool has_told_since(const std::string& robot, Time since) const;
  /// Returns why nothing is known of a robot that has told nothing since an order.
  [[nodiscard]] std::string silence_of(const std::string& robot) const;
  /// Takes messages until `enough` returns true or `most` is over. Returns the last result of
  /// `enough`.
  bool wait(Duration most, const std::function<bool()>& enough) {
    return listener_->wait(most, enough);
  }
  /// Takes messages until each robot has answered the order, for at most kAnswer. Returns the names
  /// of those that have not.
  [[nodiscard]] std::vector<std::string> wait_for_answers(const std::vector<std::string>& robots,
                                                          const std::string& order_id);

  /// Returns the robot's state, or null if it has sent none.
  [[nodiscard]] const msg::RobotState* state_of(const std::string& robot) const;
  /// Returns the program that the robot runs, or null if it is not known.
  [[nodiscard]] const msg::Program* program_of(const std::string& robot) const;
  /// Returns what the robot told about break points, or null if it told nothing.
  [[nodiscard]] const msg::Breaks* breaks_of(const std::string& robot) const;
  /// Returns the robot's answer to an order about break points or a step, or null if it has not
  /// answered it.
  [[nodiscard]] const msg::BreakAnswer* answer_of(const std::string& robot,
                                                  const std::string& order_id) const;
  [[nodiscard]] wire::Participant& participant() noexcept { return listener_->participant(); }
  [[nodiscard]] Time now() const noexcept { return listener_->now(); }

 private:
  explicit OrderSession(std::unique_ptr<TeamListener> listener);
  void note(const Message& message);

  std::unique_ptr<TeamListener> listener_;
  std::unique_ptr<wire::Endpoints> endpoints_;
  Time joined_;
  bool has_heard_monitor_ = false;
  std::map<std::string, msg::Breaks> breaks_;
  std::map<std::string, std::string> holders_;  ///< who steers each robot, as a monitor told last
};

}  // namespace galilean::monitor
