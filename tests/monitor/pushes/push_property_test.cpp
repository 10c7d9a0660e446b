// SPDX-License-Identifier: BSD-3-Clause
// Pushes to robots that do anything: what must hold whatever they, the disk, DDS and the operator
// do.
#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <set>

#include "core/random.h"
#include "tests/monitor/pushes/push_fixture.h"

namespace galilean::monitor {
namespace {

const std::vector<std::string> kAwaited{"callisto", "ganymede", "io"};

/// An order that asks for anything.
PushOrder any_order(Random& random) {
  auto order = order_for(random.below(3) > 0 ? "io" : "", random.below(2) == 0);
  if (random.below(2) == 0) order.targets = kAwaited;
  if (random.below(2) == 0) order.probation = from_seconds(random.uniform(0, 20));
  order.trial.only = order.trial.wanted && random.below(5) == 0;
  order.trial.even_if_worse = random.below(2) == 0;
  return order;
}

TrialFigures any_figures(Random& random) {
  TrialFigures figures;
  figures.now.runs = figures.next.runs = 1;
  figures.now.score.mean = random.uniform(0, 10);
  figures.next.score.mean = random.uniform(0, 10);
  return figures;
}

/// Plays one push: keeps what it asks for, answers at random, and notes what it does to robots.
class Play {
 public:
  explicit Play(std::uint64_t seed)
      : random_(seed),
        order_(any_order(random_)),
        silent_(order_.targets.empty() && random_.below(2) == 0 ? std::vector<std::string>{"europa"}
                                                                : std::vector<std::string>()),
        push_(ordered(order_, silent_)) {}

  void run() {
    for (int event = 0; event < 120; ++event) {
      happen();
      obey();
    }
    finish();
    for (int late = 0; late < 20; ++late) {
      happen();
      const auto words = words_of(push_);
      for (const auto& each : words)
        EXPECT_TRUE(each.starts_with("record reply")) << "it is over, and asks to " << each;
    }
  }
  [[nodiscard]] PushState end() const { return push_.record().progress.state; }
  [[nodiscard]] bool has_proven_canary() const { return canary_is_proven_; }

 private:
  bool chance(std::uint32_t one_in) { return random_.below(one_in) == 0; }

  void happen() {
    switch (random_.below(6)) {
      case 0:
        return bring_result();
      case 1:
      case 2:
        return reply();
      case 3:
        return push_.see_canary(chance(200), chance(200) ? "theirs" : kNewHash, now_);
      case 4:
        if (chance(15) && push_.cancel("balch")) {
          EXPECT_TRUE(push_.is_over());
        }
        return push_.see_trial(random_.below(8), 8);
      default:
        now_ += from_seconds(random_.uniform(0, 3));
        return push_.update(now_);
    }
  }

  /// Of a request that waits, or of one that nobody made.
  void bring_result() {
    if (chance(40)) return push_.take(SendFailed{}, now_);
    if (chance(10)) return push_.take(ProgramTried{any_figures(random_)}, now_);
    if (waiting_.empty()) return;
    const auto result = std::move(waiting_.front());
    waiting_.pop_front();
    push_.take(result, now_);
  }

  void reply() {
    const auto& robot = kAwaited[random_.below(3)];
    const auto status = static_cast<ReplyStatus>(chance(20) ? random_.below(7) : 3);
    auto reply = said(robot, status);
    if (chance(10)) reply.id = "another push";
    if (chance(10)) reply.id = kRollbackId;
    note_canary(reply);
    push_.take_reply(reply, now_);
  }

  /// Since when the canary runs the program, as whoever hears it must believe.
  void note_canary(const msg::ProgramReply& reply) {
    const bool is_its = canary_asked_ && reply.robot == order_.canary && reply.id == kPushId;
    if (is_its && !canary_runs_since_ && runs(reply_status(reply.status)))
      canary_runs_since_ = now_;
  }

  void obey() {
    for (auto asked = push_.take_requests(); !asked.empty(); asked = push_.take_requests())
      for (const auto& request : asked) std::visit([this](auto& each) { obey(each); }, request);
  }
  void obey(const CheckProgram& /*asked*/) {
    if (chance(10)) return waiting_.push_back(does_not_check());
    waiting_.push_back(checks());
  }
  void obey(const RecordPush& /*asked*/) {
    EXPECT_TRUE(asked_.empty()) << "it is recorded before anything of it is sent";
    is_recorded_ = !chance(10);
    waiting_.push_back(PushRecorded{is_recorded_ ? Result<void>() : Error{"the disk is full"}});
  }
  void obey(const TryProgram& /*asked*/) {
    if (chance(5)) return push_.fail("the simulator is not there");
    waiting_.push_back(chance(10) ? ProgramTried{Error{"it crashed"}}
                                  : ProgramTried{any_figures(random_)});
  }
  void obey(const EndTrial& /*asked*/) {}
  void obey(const SendProgram& sent) {
    EXPECT_TRUE(is_recorded_);
    const bool to_canary = sent.push.targets == std::vector{order_.canary};
    auto robots = sent.push.targets;
    if (robots.empty()) robots = kAwaited;
    for (const auto& robot : robots)
      EXPECT_TRUE(asked_.insert(robot).second) << robot << " is asked twice";
    if (to_canary)
      canary_asked_ = true;
    else
      expect_proven_canary();
  }
  void obey(const RollBack& back) {
    EXPECT_TRUE(canary_asked_) << "there is nothing to take back";
    EXPECT_EQ(back.robot, order_.canary);
    EXPECT_FALSE(is_taken_back_);
    is_taken_back_ = true;
  }
  void obey(const RecordReply& /*asked*/) {}
  void obey(const TellProgress& told) { EXPECT_EQ(told.push.hash, kNewHash); }

  void expect_proven_canary() {
    if (order_.canary.empty()) return;
    ASSERT_TRUE(canary_runs_since_) << "the others are asked before the canary runs it";
    EXPECT_GE(now_ - *canary_runs_since_, order_.probation.value_or(std::chrono::seconds(10)));
    EXPECT_FALSE(is_taken_back_);
    canary_is_proven_ = true;
  }

  /// All that still waits for an answer gets one, and the robots say no more.
  void finish() {
    for (int i = 0; i < 8; ++i) {
      if (!waiting_.empty()) {
        push_.take(waiting_.front(), now_);
        waiting_.pop_front();
      }
      now_ += std::chrono::seconds(30);
      push_.update(now_);
      obey();
    }
    expect_the_end();
  }

  void expect_the_end() {
    const auto end = push_.record().progress;
    EXPECT_TRUE(push_.is_over());
    EXPECT_TRUE(end.state == PushState::kDone || end.state == PushState::kFailed ||
                end.state == PushState::kCancelled);
    for (const auto& step : end.steps)
      EXPECT_TRUE(step.state != StepState::kWaiting && step.state != StepState::kRunning);
    EXPECT_TRUE(push_.take_answer()) << "who ordered it is told";
    EXPECT_FALSE(push_.take_answer()) << "once";
    if (order_.trial.only) {
      EXPECT_TRUE(asked_.empty());
    } else if (end.state == PushState::kDone) {
      for (const auto& robot : kAwaited) EXPECT_TRUE(asked_.contains(robot));
    }
  }

  Random random_;
  PushOrder order_;
  std::vector<std::string> silent_;
  Push push_;
  Time now_{};
  std::deque<PushResult> waiting_;
  std::set<std::string> asked_;
  bool is_recorded_ = false;
  bool canary_asked_ = false;
  bool canary_is_proven_ = false;
  bool is_taken_back_ = false;
  std::optional<Time> canary_runs_since_;
};

TEST(PushProperty, EndsAsksEachRobotOnceAndTheOthersAfterTheProbation) {
  constexpr std::uint64_t kPlays = 4000;
  std::map<PushState, int> ends;
  int proven = 0;
  for (std::uint64_t seed = 1; seed <= kPlays; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Play play(seed);
    play.run();
    if (testing::Test::HasFailure()) return;
    ++ends[play.end()];
    proven += play.has_proven_canary() ? 1 : 0;
  }
  for (const auto end : {PushState::kDone, PushState::kFailed, PushState::kCancelled})
    EXPECT_GE(ends[end], 200) << "too few plays end so for the rest to mean anything";
  EXPECT_GE(proven, 200);
}

}  // namespace
}  // namespace galilean::monitor
