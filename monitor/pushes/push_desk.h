// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/refusals.h"
#include "monitor/pushes/late_replies.h"
#include "monitor/pushes/push.h"
#include "monitor/pushes/push_executor.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/refusal.h"

namespace galilean::monitor {

/// Keeps the open pushes, and brings each of them its robots' replies, the results of its requests
/// and the time. It refuses an order for robots to which another push is under way. Pushes that are
/// made without this monitor are recorded, too.
///
/// Lives on the io_context's thread.
class PushDesk {
 public:
  using Finish = std::function<void(const PushAnswer&)>;

  PushDesk(const PushExecutor::Parts& parts, const Clock& clock, wire::Participant& participant);

  /// Begins a push, and calls `finish` when each robot has replied or kReplyTimeout is over. A
  /// push with a trial or a canary takes longer: `finish` is called as soon as it is recorded.
  /// An order with the id of an earlier one begins nothing, and gets the earlier one's answer. No
  /// answer is given before what it tells is in the history.
  /// Errors: the order is refused, or this machine cannot carry it out.
  void order(PushOrder order, Finish finish);
  /// Cancels a push. Errors: no such push is under way (kNotFound), or it is too late (kConflict).
  void cancel(const std::string& id, const std::string& who, const Finish& finish);
  /// Calls `finish` with the push, which is open or in the history. Errors: there is no such push
  /// (kNotFound), or the history cannot be read (kUnavailable).
  void describe(const std::string& id, Finish finish);

  /// Takes in a message that DDS brought.
  void note(const msg::ProgramPush& announced);
  void note(const msg::ProgramReply& reply);

 private:
  struct Open {
    Push push;
    std::vector<Finish> finish;             ///< of those who wait for the answer
    std::optional<PushAnswer> answer = {};  ///< the one that was given
    bool is_told_over = false;              ///< it is over, and LateReplies knows it
  };
  using OpenPtr = std::shared_ptr<Open>;

  [[nodiscard]] OpenPtr find(const std::string& id) const;
  [[nodiscard]] OpenPtr under_way_to(const std::vector<std::string>& targets) const;
  OpenPtr keep(Push push, std::vector<Finish> finish);
  /// Answers an order as the earlier one of the same id. Returns false if none is remembered.
  [[nodiscard]] bool answer_again(const std::string& id, const Finish& finish);
  void begin(PushOrder order, const Finish& finish);
  void refuse(const std::string& id, const Refusal& refusal, const Finish& finish);
  void refuse_stale(const PushOrder& order, const Stale& stale, const Finish& finish);
  void refuse_under_way(const PushOrder& order, const PushRecord& other,
                        const std::string& running_hash, const Finish& finish);
  void after_writes(const std::function<void()>& then);
  void give(Open& open, const PushAnswer& answer);
  void take(const std::string& id, const PushResult& result);
  void advance(Open& open);
  void watch();
  void watch(Open& open);
  /// Returns whether another push of others may be recorded now, and notes it.
  [[nodiscard]] bool has_room_for_others();

  PushExecutor::Parts parts_;
  const Clock& clock_;
  wire::Refusals& refusals_;
  PushExecutor executor_;
  std::deque<Time> others_;  ///< when the newest pushes of others came
  LateReplies late_;
  std::deque<std::pair<std::string, Refusal>> refused_;  ///< the newest refusals, by orders' ids
  std::deque<OpenPtr> open_;  ///< the newest last; old ones that are over are dropped
  boost::asio::steady_timer timer_;
};

}  // namespace galilean::monitor
