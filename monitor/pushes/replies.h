// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// How far a robot is with a push; the numbers are msg::ProgramReply_Constants'.
enum class ReplyStatus : std::uint8_t {
  kNoAnswer,
  kReceived,
  kRejected,
  kRunning,
  kConfirmed,
  kRolledBack,
  kUnknown  ///< a number that this release does not know
};
[[nodiscard]] ReplyStatus reply_status(std::uint8_t number);

/// The robot runs the program.
[[nodiscard]] inline bool runs(ReplyStatus status) {
  return status == ReplyStatus::kRunning || status == ReplyStatus::kConfirmed;
}

/// What one robot replied to a push.
struct RobotReply {
  std::string robot;
  ReplyStatus status = ReplyStatus::kNoAnswer;
  msg::ProgramReply reply = {};  ///< empty while there is none
  double latency_ms = 0;         ///< from the push to the first reply that decides
};

/// Why the robot does not run the program, in one clause: "io refused it: no camera".
[[nodiscard]] std::string why_not(const RobotReply& reply);

/// How long robots may take to build a program and reply.
inline constexpr Duration kReplyPatience = std::chrono::seconds(2);

/// The replies to one push: who was asked, and what each has said so far. Pure; whoever owns it
/// writes the message and brings the replies. Robots that nobody asked for but that reply (a push
/// to the team reaches all) are listed too.
class Replies {
 public:
  /// `push_id`: of the message. `awaited`: the robots whose reply makes the push complete.
  Replies(std::string push_id, std::vector<std::string> awaited, Time sent);

  /// Lists a robot that was asked but is not waited for, as it had fallen silent.
  void list(const std::string& robot);
  /// Returns false if the reply belongs to another push or tells nothing new.
  bool note(const msg::ProgramReply& reply, Time now);
  /// Returns whether each awaited robot runs the program or refused it.
  [[nodiscard]] bool complete() const;
  /// Returns whether each awaited robot runs the program.
  [[nodiscard]] bool taken_by_all() const;
  /// Returns whether each awaited robot has said its last word: refused, confirmed or rolled back.
  [[nodiscard]] bool settled() const;
  /// Returns one for each robot, in the order of their names.
  [[nodiscard]] std::vector<RobotReply> all() const;

 private:
  [[nodiscard]] bool all_awaited(const std::function<bool(ReplyStatus)>& have) const;

  std::string push_id_;
  std::vector<std::string> awaited_;
  Time sent_;
  std::map<std::string, RobotReply> replies_;
};

}  // namespace galilean::monitor
