// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// What one robot said to a push.
struct PushAnswer {
  std::string robot;
  std::string status = "no_answer";  ///< or received, rejected, running, confirmed, rolled_back
  msg::ProgramReply reply;           ///< empty while there is no answer
  double latency_ms = 0;             ///< from the push to the answer
};

/// The words for msg::ProgramReply::status.
[[nodiscard]] std::string push_status_name(std::uint8_t status);

/// One push: who was asked, and what each has said so far. Pure; whoever owns it writes the message
/// and brings the replies. Robots that nobody asked for but that answer (a team push reaches all)
/// are listed too.
class Push {
 public:
  /// `id`: of the message. `awaited`: the robots whose answer makes the push complete.
  Push(std::string id, std::vector<std::string> awaited, Time sent);

  /// A robot that was asked but is not waited for: it had fallen silent.
  void list(const std::string& robot);
  /// False if the reply belongs to another push or tells nothing new.
  bool note(const msg::ProgramReply& reply, Time now);
  /// Each awaited robot runs the program or refused it.
  [[nodiscard]] bool complete() const;
  /// Each awaited robot runs the program.
  [[nodiscard]] bool taken_by_all() const;
  /// Each awaited robot has said its last word: refused, confirmed or rolled back.
  [[nodiscard]] bool settled() const;
  /// In the order of the robots' names.
  [[nodiscard]] std::vector<PushAnswer> answers() const;

 private:
  [[nodiscard]] bool all_awaited(const std::function<bool(std::uint8_t)>& have) const;

  std::string id_;
  std::vector<std::string> awaited_;
  Time sent_;
  std::map<std::string, PushAnswer> answers_;
};

}  // namespace galilean::monitor
