// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "monitor/pushes/push.h"

namespace galilean::monitor {

/// What a program goes through before every target runs it.
struct SwapPlan {
  std::string id;                    ///< of the push
  std::vector<std::string> awaited;  ///< targets that are there to answer
  std::vector<std::string> silent;   ///< targets that are asked, but not waited for
  bool tries = false;                ///< first in simulation
  bool tries_only = false;           ///< and no further
  std::string canary;                ///< one of `awaited` that runs it before the others; or empty
  Duration probation = std::chrono::seconds(10);  ///< that the canary must run it for
};

/// One of a transaction's steps, in words that messages use.
struct SwapStep {
  std::string name;               ///< check, try, canary or rest
  std::string state = "waiting";  ///< or running, done, failed, cancelled, left_out
  std::string detail;             ///< one sentence; empty where there is nothing to say
};

/// How far a push has come, as it is told and remembered.
struct SwapProgress {
  std::string state = "running";  ///< done, failed, cancelled, interrupted; empty: not ours
  std::vector<SwapStep> steps;
  std::string trial_json;  ///< what trying found; empty while it found nothing
};

/// A swap as a transaction: check → try → canary → the rest, of which trying and canary may be left
/// out. A step that fails ends it: what has not begun does not begin, and a canary goes back to
/// what it ran. Pure: whoever owns it does the acts that it asks for and tells what came of them.
class SwapTransaction {
 public:
  /// How long robots may take to build a program and answer.
  static constexpr Duration kPatience = std::chrono::seconds(2);

  /// Where among `steps` the canary's is.
  static constexpr std::size_t kCanaryStep = 2;

  enum class Act {
    kCheck,       ///< against each target's catalog; then `checked`
    kTry,         ///< in simulation; then `tried`
    kEndTrial,    ///< nobody waits for it any more
    kPushCanary,  ///< to the canary alone
    kPushRest,    ///< to `rest`, or to all targets where there is no canary
    kTakeBack     ///< have the canary run what it ran before
  };

  SwapTransaction(SwapPlan plan, Time now);
  /// A push that somebody else has made: it is past all steps but its robots' answers.
  [[nodiscard]] static SwapTransaction of_others(SwapPlan plan, Time now);

  /// What to do now, each once, in this order.
  [[nodiscard]] std::vector<Act> take_acts();

  /// An objection ends the transaction; an empty one lets it go on.
  void checked(const std::string& objection, Time now);
  void tried(const std::string& objection, const std::string& finding, Time now);
  /// How far the running step is.
  void describe(const std::string& detail);
  /// This machine could not do an act.
  void fail(const std::string& why);
  /// False if the reply belongs to another push or tells nothing new.
  bool note(const msg::ProgramReply& reply, Time now);
  /// What is heard of a robot, besides its replies: silence, or another program.
  void see(const std::string& robot, bool silent, const std::string& running_hash, Time now);
  /// Time passes.
  void update(Time now);
  /// False if it is too late: every target has been asked, or it is over.
  bool cancel(const std::string& who);

  /// running, done, failed or cancelled.
  [[nodiscard]] const std::string& state() const noexcept { return state_; }
  [[nodiscard]] bool over() const noexcept { return state_ != "running"; }
  /// Some robot was sent the program.
  [[nodiscard]] bool has_reached_robots() const noexcept { return canary_push_ || rest_push_; }
  [[nodiscard]] const std::vector<SwapStep>& steps() const noexcept { return steps_; }
  [[nodiscard]] const SwapPlan& plan() const noexcept { return plan_; }
  /// The targets without the canary.
  [[nodiscard]] std::vector<std::string> rest() const;
  /// What each target has said so far, in the order of their names.
  [[nodiscard]] std::vector<PushAnswer> answers() const;
  /// Grows with each change of a step.
  [[nodiscard]] unsigned version() const noexcept { return version_; }

 private:
  [[nodiscard]] SwapStep* running_step();
  [[nodiscard]] bool is_at(std::string_view step) const;
  void begin_next(Time now);
  void begin(SwapStep& step, Time now);
  void finish_step(const std::string& detail, Time now);
  void end(const std::string& step_state, const std::string& state, const std::string& detail);
  [[nodiscard]] bool canary_may_run() const;
  void judge_canary(Time now);
  void judge_rest(Time now);
  [[nodiscard]] std::string shortcomings() const;

  SwapPlan plan_;
  std::string state_ = "running";
  std::vector<SwapStep> steps_;
  std::vector<Act> acts_;
  Time began_;  ///< the running step
  std::optional<Push> canary_push_;
  std::optional<Push> rest_push_;
  std::optional<Time> canary_runs_since_;
  unsigned version_ = 0;
};

}  // namespace galilean::monitor
