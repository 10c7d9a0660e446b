// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/background/worker.h"
#include "monitor/pushes/history/history.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Brings pushes that were interrupted or failed together with what their robots tell later: by a
/// reply, or by a state that names the program that they run. A push that all its robots run is
/// then marked as told later. Nothing is asked of a push once a newer one goes to one of its
/// robots.
///
/// Lives on the io_context's thread.
class LateReplies {
 public:
  /// Reports a push that was marked. It is called on the io_context's thread.
  using Report = std::function<void(const PushRecord& push)>;

  LateReplies(Worker& worker, History& history, const Team& team, Report report)
      : worker_(worker), history_(history), team_(team), report_(std::move(report)) {}

  /// Looks for pushes of a former monitor that may be told of.
  void start();
  /// Takes in a push that ended just now.
  void add(const PushRecord& push);
  /// Takes in that a newer push goes to `targets`.
  void supersede(const std::vector<std::string>& targets);
  /// Takes in a reply to a push that is over, or that this monitor did not begin.
  void note(const msg::ProgramReply& reply);
  /// Looks at what the robots run. Call it some times a second.
  void watch();

 private:
  void see(PushRecord& push);

  Worker& worker_;
  History& history_;  ///< only the worker's thread uses it
  const Team& team_;
  Report report_;
  std::vector<PushRecord> open_;  ///< pushes that may be told of
};

}  // namespace galilean::monitor
