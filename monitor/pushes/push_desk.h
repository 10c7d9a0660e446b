// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "monitor/pushes/push.h"
#include "monitor/pushes/push_executor.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/refusal.h"

namespace galilean::monitor {

/// Keeps the pushes that are open, and brings each what concerns it: orders, replies, time, and
/// what came of its requests. Robots that one push is under way to are not given another. Pushes
/// that others make are written down too.
///
/// Lives on the io_context's thread.
class PushDesk {
 public:
  using Finish = std::function<void(const PushAnswer&)>;

  PushDesk(const PushExecutor::Parts& parts, const Clock& clock, wire::Participant& participant);

  /// Finishes when each robot has replied or kReplyPatience is over; once it is checked, while it
  /// is running, where it is tried or has a canary.
  void order(PushOrder order, Finish finish);
  /// Refused: no such push is under way (kNotFound), or it is too late (kConflict).
  void cancel(const std::string& id, const std::string& who, const Finish& finish);
  /// A push of this run of the monitor, or one that the history remembers; else kNotFound.
  void describe(const std::string& id, Finish finish);

  /// What DDS brought.
  void note(const msg::ProgramPush& push);
  void note(const msg::ProgramReply& reply);

 private:
  struct Open {
    Push push;
    Finish finish;  ///< who ordered it waits; null once it was told
  };
  using OpenPtr = std::shared_ptr<Open>;

  [[nodiscard]] OpenPtr find(const std::string& id) const;
  [[nodiscard]] OpenPtr under_way_to(const std::vector<std::string>& targets) const;
  OpenPtr keep(Push push, Finish finish);
  void refuse_stale(const PushOrder& order, const Stale& stale, Finish finish);
  void take(const std::string& id, const PushResult& result);
  void advance(Open& open);
  void watch();
  void watch(Open& open);

  PushExecutor::Parts parts_;
  const Clock& clock_;
  PushExecutor executor_;
  std::deque<OpenPtr> open_;  ///< the newest last; old ones are let go
  boost::asio::steady_timer timer_;
};

}  // namespace galilean::monitor
