// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "robot/executive/executive.h"

namespace galilean::robot {

/// Remembers the push that each program came from, and the orders to roll it back, and answers them
/// as the program fares. Any thread but the control loop may call it.
class PushLedger {
 public:
  struct Push {
    std::string id;
    std::string hash;
    std::vector<msg::Diagnostic> warnings;
  };
  struct Running {
    std::shared_ptr<const Description> program;  ///< null: none yet
    std::uint64_t since_tick = 0;
    bool proven = false;
    bool has_predecessor = false;  ///< there is a program to roll back to
    [[nodiscard]] std::string hash() const { return program ? program->program.hash : ""; }
  };

  explicit PushLedger(Executive& executive) : executive_(executive) {}

  /// Returns what the events told so far.
  [[nodiscard]] Running running() const;
  /// Returns the hash of the program that runs now, even if no event told of it yet; empty: none.
  [[nodiscard]] std::string running_hash() const;
  /// Lets the executive build `program` and take it over, and enters the push. If that program runs
  /// already, none is exchanged. What runs is judged by the executive, because events come later
  /// than programs. Returns the answers that can be given at once. Requires: no program waits for
  /// its first tick. Errors: a program with another hash than `replaces`, which is not empty, runs;
  /// as Executive::load.
  [[nodiscard]] Result<std::vector<msg::ProgramReply>> load(bhdl::Program program,
                                                            const ProbationRules& rules, Push push,
                                                            const std::string& replaces);
  /// Orders the executive to roll back the program that `order` names by its hash. What runs is
  /// judged by the executive, as in `load`. Errors: another program runs, no event told of that one
  /// yet, none ran before it, or too many orders wait.
  [[nodiscard]] Result<void> roll_back(Push order, std::string_view reason);
  /// Returns whether a push brought the program, or another push would have. It is known of the
  /// newest kPushedKept.
  [[nodiscard]] bool pushed(ProgramId program) const;
  /// Returns the answers that `event` causes.
  [[nodiscard]] std::vector<msg::ProgramReply> answers(const Event& event);

 private:
  static constexpr std::size_t kPushedKept = 64;

  [[nodiscard]] std::shared_ptr<const Description> runs_now() const;
  [[nodiscard]] std::vector<msg::ProgramReply> join_running(Push push);
  void answer_those_who_joined(ProgramId program, std::vector<msg::ProgramReply>& replies);
  void note_pushed(ProgramId program);
  [[nodiscard]] std::vector<msg::ProgramReply> started(const Event& event);
  [[nodiscard]] std::vector<msg::ProgramReply> confirmed(const Event& event);
  [[nodiscard]] std::vector<msg::ProgramReply> rolled_back(const Event& event);
  [[nodiscard]] msg::ProgramReply rollback_reply(const Push& push, const Event& event,
                                                 const Description* failed) const;
  [[nodiscard]] msg::ProgramReply reply(const Push& push, std::uint8_t status) const;

  Executive& executive_;
  mutable std::mutex mutex_;
  Running running_;
  std::set<ProgramId> pushed_;             ///< the newest programs that pushes brought
  std::multimap<ProgramId, Push> pushes_;  ///< pushes that are not yet confirmed and still may be
  std::multimap<ProgramId, Push> joined_;  ///< pushes of a program that runs already, of which no
                                           ///< event told yet
  std::multimap<ProgramId, Push> orders_;  ///< orders to roll back that are not yet carried out
};

}  // namespace galilean::robot
