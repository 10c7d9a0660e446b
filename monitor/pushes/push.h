// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "monitor/pushes/push_content.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/push_requests.h"
#include "monitor/pushes/refusal.h"
#include "monitor/pushes/rollout/rollout.h"
#include "monitor/pushes/rollout/steps.h"

namespace galilean::monitor {

/// One push, from its order to its end. It is a transaction of four steps: check, try, canary,
/// rest. Trial and canary may be left out. A step that fails ends the push, and the steps after it
/// do not begin. If that is the canary's step, the canary is ordered back to the program that it
/// ran before.
///
/// A push does no input or output. Its owner carries its requests out, and brings their results,
/// the robots' replies and the time, in any order and at any time.
class Push {
 public:
  Push(PushOrder order, OrderTargets targets, PushIdentity identity);
  /// Returns a push that was made without this monitor. It is recorded, and so are the replies.
  [[nodiscard]] static Push of_others(const msg::ProgramPush& message, const OrderTargets& targets,
                                      Time now);

  /// Returns the requests that are due, each once, in the order in which to carry them out. Call it
  /// until it returns none.
  [[nodiscard]] std::vector<PushRequest> take_requests();
  /// Returns the answer to the order, once. A push with a trial or a canary is answered as soon as
  /// it is recorded or has ended, any other when it has ended.
  [[nodiscard]] std::optional<PushAnswer> take_answer() {
    return std::exchange(answer_, std::nullopt);
  }

  /// Takes in the result of a request.
  void take(const PushResult& result, Time now);
  /// Ends the push as failed. Call it if this machine could not carry a request out.
  void fail(const std::string& why) { end(StepState::kFailed, why); }
  /// Takes in a robot's reply. Ignores a reply to another push, and one that tells nothing new.
  void take_reply(const msg::ProgramReply& reply, Time now);
  /// Takes in what is heard of the canary besides its replies.
  void see_canary(bool silent, const std::string& running_hash, Time now);
  /// Takes in how many of the trial's runs are over.
  void see_trial(std::size_t finished, std::size_t all);
  /// Takes in the time.
  void update(Time now) {
    judge_canary(now);
    judge_rest(now);
  }
  /// Cancels the push. Errors: every target has been sent the program, or the push is over.
  [[nodiscard]] Result<void, Refusal> cancel(const std::string& who);

  [[nodiscard]] bool is_meant_by(const msg::ProgramReply& reply) const {
    return content_.is_meant_by(reply);
  }
  [[nodiscard]] bool is_over() const { return steps_.state() != PushState::kRunning; }
  /// Returns whether the program has errors. Such a push is not recorded.
  [[nodiscard]] bool is_refused() const noexcept { return is_refused_; }
  [[nodiscard]] bool is_ours() const noexcept { return content_.is_ours(); }
  [[nodiscard]] const PushOrder& order() const noexcept { return content_.order(); }
  [[nodiscard]] const std::string& id() const noexcept { return content_.identity().id; }
  /// Returns how many replies were dropped; see Replies.
  [[nodiscard]] std::uint64_t replies_dropped() const noexcept {
    return rollout_.replies_dropped();
  }
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
  void send(SendProgram program);
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
  [[nodiscard]] Progress progress() const { return {steps_.state(), steps_.all(), trial_, 0}; }

  PushContent content_;
  Rollout rollout_;
  Steps steps_;
  nlohmann::json trial_ = nullptr;  ///< the trial's figures; null while there are none
  bool is_refused_ = false;
  bool is_recording_asked_ = false;  ///< no progress is published before
  bool is_trial_under_way_ = false;

  std::vector<PushRequest> requests_;
  std::optional<PushAnswer> answer_;
  bool is_answered_ = false;
  unsigned told_changes_ = 0;  ///< Steps::changes() when the progress was published last
};

}  // namespace galilean::monitor
