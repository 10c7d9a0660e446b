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
  /// Returns whether an order may be carried out. If not, it has told whoever gave the order.
  using Admit = std::function<bool()>;

  PushDesk(const PushExecutor::Parts& parts, const Clock& clock, wire::Participant& participant);

  /// Begins a push, and calls `finish` when each robot has replied or kReplyTimeout is over. A
  /// push with a trial or a canary takes longer: `finish` is called as soon as it is recorded.
  /// An order with the id of an earlier one begins nothing, and gets the earlier one's answer, also
  /// that of a former monitor. `admit` is asked of any other, once. No answer is given before what
  /// it tells is in the history; where the disk fails, the answer says so.
  /// Errors: the order is refused, or this machine cannot carry it out.
  void order(PushOrder order, const Admit& admit, const Finish& finish);
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
    /// What waits until the program's hash is known, or the push is over.
    std::vector<std::function<void()>> after_check = {};
  };
  using OpenPtr = std::shared_ptr<Open>;

  [[nodiscard]] OpenPtr find(const std::string& id) const;
  [[nodiscard]] OpenPtr under_way_to(const std::vector<std::string>& targets) const;
  OpenPtr keep(Push push, std::vector<Finish> finish);
  /// Answers an order as the earlier one of the same id. Returns false if none is remembered.
  [[nodiscard]] bool answer_again(const std::string& id, const Finish& finish);
  /// Returns the answer to the order of this id that the history tells of, if it tells of one.
  [[nodiscard]] static Result<std::optional<PushAnswer>> kept_answer(const History& history,
                                                                     const std::string& id);
  void begin(const PushOrder& order, const Finish& finish);
  void refuse(const PushOrder& order, const Refusal& refusal, const Finish& finish);
  /// Remembers a refusal for an order that comes again.
  void remember(const PushRecord& push, const Refusal& refusal);
  void refuse_stale(const PushOrder& order, const Stale& stale, const Finish& finish);
  void refuse_under_way(const PushOrder& order, const PushRecord& other,
                        const std::string& running_hash, const Finish& finish);
  /// `then` is told why the history does not hold all that was written before; empty: it does.
  void after_writes(const std::function<void(const std::string& not_kept)>& then);
  void give(Open& open, const PushAnswer& answer);
  /// Gives an answer once what it tells is in the history.
  void give(const std::vector<Finish>& waiting, const PushAnswer& answer);
  void take(const std::string& id, const PushResult& result);
  void advance(Open& open);
  void watch();
  void watch(Open& open);
  /// Returns whether another row beside those of this monitor's pushes may be written now, and
  /// notes it in `newest`.
  [[nodiscard]] bool has_room(std::deque<Time>& newest) const;

  PushExecutor::Parts parts_;
  const Clock& clock_;
  wire::Refusals& refusals_;
  PushExecutor executor_;
  std::deque<Time> others_;         ///< when the newest pushes of others came
  std::deque<Time> kept_refusals_;  ///< when the newest refusals were kept
  LateReplies late_;
  std::deque<std::pair<std::string, Refusal>> refused_;  ///< the newest refusals, by orders' ids
  std::deque<OpenPtr> open_;  ///< the newest last; old ones that are over are dropped
  boost::asio::steady_timer timer_;
};

}  // namespace galilean::monitor
