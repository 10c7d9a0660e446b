// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "monitor/orders/obedience.h"
#include "monitor/orders/operator.h"
#include "monitor/orders/order_session.h"

namespace galilean::monitor {

/// What became of a command to one robot.
struct CommandOutcome {
  std::string robot;
  std::string words;  ///< such as "stands still"
  bool is_well = false;
};

/// One command to robots, from what they tell before it to what they tell after it. A robot obeys
/// by a state of its own that is received after the command.
class CommandRound {
 public:
  /// Requires: `session` and `whom` outlive this. `signer` signs the command; null: nobody does.
  CommandRound(OrderSession& session, Operator::Word word, const Addressees& whom,
               std::shared_ptr<OrderSigner> signer = nullptr)
      : session_(session),
        speaker_(session.participant(), std::move(signer)),
        word_(word),
        whom_(whom) {}

  /// Tells whoever listens before it is known who is there. Returns false if DDS did not accept it.
  [[nodiscard]] bool say_at_once();
  /// Gives the command, and waits until all robots obeyed or refused, for at most
  /// OrderSession::kAnswer. Who is to stand still is told again all that time. Returns the outcome
  /// for each robot that is named or known. Errors: none of them is there, another operator steers
  /// one of them and the command does not stop it, or DDS did not accept the command.
  [[nodiscard]] Result<std::vector<CommandOutcome>> run();

 private:
  void note_before();
  /// Returns whether all robots have obeyed or refused. One that has is done, whoever commands it
  /// later.
  [[nodiscard]] bool all_done();
  /// Returns why the robot refused the last command, or an empty text if it did not.
  [[nodiscard]] std::string refusal_of(const std::string& robot) const;
  void tell_again();
  [[nodiscard]] RobotReport report_of(const std::string& robot) const;
  [[nodiscard]] CommandOutcome outcome(const std::string& robot);

  OrderSession& session_;
  Operator speaker_;
  Operator::Word word_;
  const Addressees& whom_;
  std::vector<std::string> robots_;            ///< that are named or known
  std::map<std::string, RobotReport> before_;  ///< what each told before the command
  std::map<std::string, RobotReport> obeyed_;  ///< what each told when it had obeyed
  Time said_{}, said_last_{};
};

}  // namespace galilean::monitor
