#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "robot/executive/executive.h"

namespace galilean::robot {

/// Remembers which push each program came from, and answers for it as it fares. Any thread but the
/// control loop.
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
    [[nodiscard]] std::string hash() const { return program ? program->program.hash : ""; }
  };

  explicit PushLedger(Executive& executive) : executive_(executive) {}

  [[nodiscard]] Running running() const;
  /// Has the executive build and take over `program`, and enters the push.
  [[nodiscard]] Result<ProgramId> load(bhdl::Program program, Push push);
  /// Enters a push of what runs already: nothing is exchanged.
  [[nodiscard]] std::vector<msg::ProgramReply> join_running(Push push);
  /// What there is to answer because of `event`.
  [[nodiscard]] std::vector<msg::ProgramReply> answers(const Event& event);

 private:
  [[nodiscard]] std::vector<msg::ProgramReply> started(const Event& event);
  [[nodiscard]] std::vector<msg::ProgramReply> confirmed(const Event& event);
  [[nodiscard]] std::vector<msg::ProgramReply> rolled_back(const Event& event);
  [[nodiscard]] msg::ProgramReply reply(const Push& push, std::uint8_t status) const;

  Executive& executive_;
  mutable std::mutex mutex_;
  Running running_;
  std::multimap<ProgramId, Push> pushes_;  ///< that are not yet confirmed
};

}  // namespace galilean::robot
