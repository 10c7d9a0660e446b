// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "monitor/background/worker.h"
#include "monitor/pushes/history/history.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Brings pushes that are over together with what their robots tell later: by a reply, or by a
/// state that names the program that they run. A robot of which it is not known what became of a
/// push is watched until it tells, or a newer push is sent to it. A push that was interrupted or
/// failed and that all its robots run is then marked as told later.
///
/// Lives on the io_context's thread.
class LateReplies {
 public:
  /// So long a robot's state must tell the same. Its reply, which tells more, comes before.
  static constexpr Duration kSettled = std::chrono::seconds(1);
  /// Reports a push that was marked. It is called on the io_context's thread.
  using Report = std::function<void(const PushRecord& push)>;

  /// Requires: all of them outlive this; `clock` is the team's.
  LateReplies(Worker& worker, History& history, const Team& team, const Clock& clock, Report report)
      : worker_(worker),
        history_(history),
        team_(team),
        clock_(clock),
        report_(std::move(report)) {}

  /// Looks for pushes of a former monitor that may be told of.
  void start();
  /// Takes in a push that ended just now.
  void add(const PushRecord& push);
  /// Takes in that a newer push goes to `targets`; empty: to the team.
  void supersede(const std::vector<std::string>& targets);
  /// Takes in a reply to a push that is over, or that this monitor did not begin.
  void note(const msg::ProgramReply& reply);
  /// Looks at what the robots run. Call it some times a second.
  void watch();

 private:
  /// What a robot's states tell of a push.
  struct Watched {
    ReplyStatus known = ReplyStatus::kNoAnswer;  ///< what the history tells
    bool runs_it = false;                        ///< what its states tell
    std::optional<Time> since;                   ///< since when they tell so
  };
  struct Open {
    std::string id, hash;
    std::map<std::string, Watched> robots;
  };

  [[nodiscard]] static Open open_of(const PushRecord& push);
  [[nodiscard]] Watched* find(const std::string& push_id, const std::string& robot);
  void see(const Open& push, const std::string& name, Watched& watched);
  void failed(const msg::ProgramReply& reply, const std::string& why);

  Worker& worker_;
  History& history_;  ///< only the worker's thread uses it
  const Team& team_;
  const Clock& clock_;
  Report report_;
  std::vector<Open> open_;  ///< pushes that may be told of; each robot is in one of them
};

}  // namespace galilean::monitor
