// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "robot/executive/executive.h"

namespace galilean::robot {

/// Remembers which push each program came from and who ordered it off again, and answers for it as
/// it fares. Any thread but the control loop.
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
    bool has_predecessor = false;  ///< which a rollback would lead to
    [[nodiscard]] std::string hash() const { return program ? program->program.hash : ""; }
  };

  explicit PushLedger(Executive& executive) : executive_(executive) {}

  [[nodiscard]] Running running() const;
  /// Has the executive build and take over `program`, and enters the push.
  [[nodiscard]] Result<ProgramId> load(bhdl::Program program, const ProbationRules& rules,
                                       Push push);
  /// Enters a push of what runs already: nothing is exchanged.
  [[nodiscard]] std::vector<msg::ProgramReply> join_running(Push push);
  /// Has the executive take off the program that `order` names by its hash. The reason why not, if
  /// it does not.
  [[nodiscard]] std::optional<std::string> roll_back(Push order, std::string_view reason);
  /// What there is to answer because of `event`.
  [[nodiscard]] std::vector<msg::ProgramReply> answers(const Event& event);

 private:
  [[nodiscard]] std::vector<msg::ProgramReply> started(const Event& event);
  [[nodiscard]] std::vector<msg::ProgramReply> confirmed(const Event& event);
  [[nodiscard]] std::vector<msg::ProgramReply> rolled_back(const Event& event);
  [[nodiscard]] msg::ProgramReply rollback_reply(const Push& push, const Event& event,
                                                 const Description* failed) const;
  [[nodiscard]] msg::ProgramReply reply(const Push& push, std::uint8_t status) const;

  Executive& executive_;
  mutable std::mutex mutex_;
  Running running_;
  std::multimap<ProgramId, Push> pushes_;  ///< that are not yet confirmed and may still be
  std::multimap<ProgramId, Push> orders_;  ///< to roll back, which are not yet obeyed
};

}  // namespace galilean::robot
