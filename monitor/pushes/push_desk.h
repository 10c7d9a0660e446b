// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/background/worker.h"
#include "monitor/pushes/history.h"
#include "monitor/pushes/open_push.h"
#include "monitor/pushes/outcome.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/swap_transaction.h"
#include "monitor/pushes/target_check.h"
#include "monitor/pushes/trial_room.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Carries pushes out, each a SwapTransaction: does the acts that it asks for, writes its steps
/// down and tells them on rt/team/push_progress. Robots that one push is under way to are not given
/// another. Pushes that others make are written down too.
///
/// Lives on the io_context's thread; checking, the disk and DDS writes happen on a worker's.
class PushDesk {
 public:
  struct Parts {
    boost::asio::io_context& io;
    Worker& worker;
    const Clock& clock;
    Team& team;
    const ProgramLibrary& library;
    History& history;  ///< the worker's alone
    const TrialRoom& trials;
  };

  PushDesk(const Parts& parts, wire::Participant& participant);

  /// Finishes when each robot has answered or SwapTransaction::kPatience is over; with 202, once it
  /// is checked, where it is tried or has a canary. Refused: 404, 409, 422 or 503.
  void order(PushOrder order, Finish finish);
  /// 404: no such push is under way; 409: too late.
  void cancel(const std::string& id, const std::string& who, Finish finish);
  /// A push of this run of the monitor, or one that the history remembers; else 404.
  void describe(const std::string& id, Finish finish);

  /// What DDS brought.
  void note(const msg::ProgramPush& push);
  void note(const msg::ProgramReply& reply);

 private:
  using OpenPtr = std::shared_ptr<OpenPush>;

  [[nodiscard]] OpenPtr find(const std::string& id) const;
  [[nodiscard]] OpenPtr taken_back_by(const std::string& order_id) const;
  [[nodiscard]] OpenPtr under_way_to(const std::vector<std::string>& targets) const;
  OpenPtr keep(OpenPush open);
  void refuse_stale(const PushOrder& order, const Stale& stale, Finish finish);
  void go_on(const OpenPtr& open);
  void give_up(const OpenPtr& open, const std::string& why);
  void act(const OpenPtr& open, SwapTransaction::Act act);
  void check(const OpenPtr& open);
  void take_check(const OpenPtr& open, TargetCheck check);
  void write_down(const OpenPtr& open);
  void try_out(const OpenPtr& open);
  void take_trial(const OpenPtr& open, const Result<TrialFigures>& result);
  void push_canary(const OpenPtr& open);
  void push_rest(const OpenPtr& open);
  void take_back(const OpenPtr& open);
  void send(const OpenPtr& open, const std::vector<std::string>& targets);
  void tell(const OpenPtr& open);
  void watch();
  void look_after(const OpenPtr& open);

  Parts parts_;
  wire::Writer<msg::ProgramPush> pushes_;
  wire::Writer<msg::ProgramRollback> rollbacks_;
  wire::Writer<msg::PushProgress> progress_;
  std::deque<OpenPtr> open_;  ///< the newest last; old ones are let go
  boost::asio::steady_timer timer_;
};

}  // namespace galilean::monitor
