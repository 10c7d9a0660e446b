// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "monitor/pushes/push_content.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/push_requests.h"
#include "monitor/pushes/refusal.h"
#include "monitor/pushes/rollout.h"
#include "monitor/pushes/steps.h"

namespace galilean::monitor {

/// One push, from the order to its end, as a transaction: check → try → canary → the rest, of which
/// trying and canary may be left out. A step that fails ends it: what has not begun does not begin,
/// and a canary goes back to what it ran.
///
/// Pure: what happens and the time come in, what it asks for goes out. Whoever owns it carries the
/// requests out and brings what comes of them, in any order and at any time.
class Push {
 public:
  Push(PushOrder order, OrderTargets targets, PushIdentity identity);
  /// A push that somebody made past this monitor: all that is left of it is its robots' replies.
  [[nodiscard]] static Push of_others(const msg::ProgramPush& message, const OrderTargets& targets,
                                      Time now);

  /// Returns what to do now, each once, in this order; to be asked until it returns nothing.
  [[nodiscard]] std::vector<PushRequest> take_requests();
  /// Returns what whoever ordered it is to be told, once: that it is accepted, where it takes long,
  /// else what became of it.
  [[nodiscard]] std::optional<PushAnswer> take_answer() {
    return std::exchange(answer_, std::nullopt);
  }

  /// What came of a request.
  void take(const PushResult& result, Time now);
  /// This machine could not do what was asked for.
  void fail(const std::string& why) { end(StepState::kFailed, why); }
  /// A robot replied. Nothing happens if it is to another push, or tells nothing new.
  void take_reply(const msg::ProgramReply& reply, Time now);
  /// What is heard of the canary besides its replies.
  void see_canary(bool silent, const std::string& running_hash, Time now);
  /// How many of the trial's runs are over.
  void see_trial(std::size_t finished, std::size_t all);
  /// Time passes.
  void update(Time now) {
    judge_canary(now);
    judge_rest(now);
  }
  /// Errors: it is too late, as every target has been sent the program or the push is over.
  [[nodiscard]] Result<void, Refusal> cancel(const std::string& who);

  [[nodiscard]] bool is_meant_by(const msg::ProgramReply& reply) const {
    return content_.is_meant_by(reply);
  }
  [[nodiscard]] bool is_over() const { return steps_.state() != PushState::kRunning; }
  /// Returns whether the program did not check: there never was such a push.
  [[nodiscard]] bool is_refused() const noexcept { return is_refused_; }
  [[nodiscard]] bool is_ours() const noexcept { return content_.is_ours(); }
  [[nodiscard]] const PushOrder& order() const noexcept { return content_.order(); }
  [[nodiscard]] const std::string& id() const noexcept { return content_.identity().id; }
  [[nodiscard]] PushRecord record() const {
    return content_.record(progress(), rollout_.replies());
  }

 private:
  Push(PushContent content, const OrderTargets& targets);

  void handle(const ProgramChecked& checked, Time now);
  void handle(const PushRecorded& recorded, Time now);
  void handle(const ProgramTried& tried, Time now);
  void handle(const SendFailed& failed, Time now);
  void handle(const RequestFailed& failed, Time now);
  void begin_next(Time now);
  void begin(StepKind kind, Time now);
  void finish_step(const std::string& detail, Time now);
  void end(StepState how, const std::string& detail);
  void judge_canary(Time now) {
    if (steps_.is_at(StepKind::kCanary)) obey(rollout_.judge_canary(now), now);
  }
  void judge_rest(Time now) {
    if (steps_.is_at(StepKind::kRest)) obey(rollout_.judge_rest(now), now);
  }
  void obey(const Verdict& verdict, Time now);
  void answer(PushAnswer answer) {
    if (!std::exchange(is_answered_, true)) answer_.emplace(std::move(answer));
  }
  [[nodiscard]] Progress progress() const { return {steps_.state(), steps_.all(), trial_}; }

  PushContent content_;
  Rollout rollout_;
  Steps steps_;
  nlohmann::json trial_ = nullptr;  ///< what it found
  bool is_refused_ = false;
  bool is_recording_asked_ = false;  ///< before that nobody is told of it
  bool is_trial_under_way_ = false;

  std::vector<PushRequest> requests_;
  std::optional<PushAnswer> answer_;
  bool is_answered_ = false;
  unsigned told_changes_ = 0;
};

}  // namespace galilean::monitor
