// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// How far a robot is with a push. The numbers are those of msg::ProgramReply_Constants.
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

/// Returns whether the robot runs the program.
[[nodiscard]] inline bool runs(ReplyStatus status) {
  return status == ReplyStatus::kRunning || status == ReplyStatus::kConfirmed;
}

/// What one robot replied to a push.
struct RobotReply {
  std::string robot;
  ReplyStatus status = ReplyStatus::kNoAnswer;
  msg::ProgramReply reply = {};  ///< empty before the first reply
  double latency_ms = 0;         ///< from the push to the reply that accepts or refuses it
};

/// Returns a clause that says why the robot does not run the program, such as "io refused it: no
/// camera".
[[nodiscard]] std::string failure_reason(const RobotReply& reply);

/// How long robots may take to build a program and reply.
inline constexpr Duration kReplyTimeout = std::chrono::seconds(2);

/// The replies to one push, by robot. The class does no input or output: its owner sends the push
/// and brings the replies. A robot that was not asked but replies is listed, too, because a push to
/// the team reaches all robots. Whoever writes to DDS can invent such robots, so the newest
/// kMostUnasked of them are kept.
class Replies {
 public:
  static constexpr std::size_t kMostUnasked = 256;

  /// `push_id` is the id of the message. `awaited` are the robots whose replies make the push
  /// complete.
  Replies(std::string push_id, std::vector<std::string> awaited, Time sent);

  /// Takes in a reply. Returns false if it belongs to another push or tells nothing new.
  bool note(const msg::ProgramReply& reply, Time now);
  /// Returns whether each awaited robot runs the program or refused it.
  [[nodiscard]] bool complete() const;
  /// Returns whether each awaited robot runs the program.
  [[nodiscard]] bool taken_by_all() const;
  /// Returns whether each awaited robot has refused, confirmed or rolled back the program.
  [[nodiscard]] bool settled() const;
  /// Returns one reply for each robot, in the order of their names.
  [[nodiscard]] std::vector<RobotReply> all() const;
  /// Returns how many robots that were not asked were dropped with their replies, because newer
  /// ones needed their places.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  void list(const std::string& robot);
  void list_unasked(const std::string& robot);
  [[nodiscard]] bool all_awaited(const std::function<bool(ReplyStatus)>& have) const;

  std::string push_id_;
  std::vector<std::string> awaited_;
  Time sent_;
  std::map<std::string, RobotReply> replies_;
  std::deque<std::string> unasked_;  ///< the oldest first
  std::uint64_t dropped_ = 0;
};

}  // namespace galilean::monitor
