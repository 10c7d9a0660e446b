// SPDX-License-Identifier: BSD-3-Clause
// Five operators who do anything at any time: what must hold of leases whatever they do.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "core/random.h"
#include "monitor/lease/lease_desk.h"

namespace galilean::monitor {
namespace {

/// Sanitizers make each of them dear. The build without them plays all.
constexpr int kInterleavings = GALILEAN_SANITIZED ? 100'000 : 1'000'000;
constexpr int kOperators = 5;
const std::array<std::string, 3> kRobots{"callisto", "ganymede", "io"};

/// A robot's lease as the changes that were told make it.
struct Told {
  std::string holder, asker;
  Time asked{};
};

class Play {
 public:
  explicit Play(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < kOperators; ++i) {
      last_word_[name(i)] = Time{};
      says_nothing_[name(i)] = false;
    }
  }

  void run(int steps) {
    for (int i = 0; i < steps && !testing::Test::HasFailure(); ++i) {
      clock_.advance(from_seconds(random_.below(4) == 0 ? random_.uniform(0, 6) : 0.05));
      look();
      happen();
      look();
      expect_one_hand_at_most();
      expect_answers_in_time();
    }
  }

  [[nodiscard]] const std::set<LeaseChange::Kind>& seen() const { return seen_; }
  [[nodiscard]] long refusals() const { return refusals_; }

 private:
  void look() {
    desk_.refresh();
    take_in_changes();
  }

  static std::string name(int i) { return std::string(1, static_cast<char>('a' + i)); }

  /// One of the tabs of one of the operators.
  OperatorId anybody() {
    return {.name = name(static_cast<int>(random_.below(kOperators))),
            .account = "operator",
            .client = std::to_string(random_.below(2))};
  }
  LeaseDesk::Robots any_robots() {
    if (random_.below(4) == 0) return {kRobots.begin(), kRobots.end()};
    return {kRobots[random_.below(kRobots.size())]};
  }

  void happen() {
    const OperatorId who = anybody();
    const auto what = random_.below(12);
    if (what == 0) return void(says_nothing_[who.name] = true);
    if (what == 1) says_nothing_[who.name] = false;
    if (what != 2 && says_nothing_[who.name]) return;
    last_word_[who.name] = clock_.now();
    if (what == 2) return stop(who);
    if (what < 5) return desk_.hear(who);
    if (what < 8) return steer(who);
    static constexpr std::array kDeeds{LeaseDeed::kAsk,  LeaseDeed::kAsk,     LeaseDeed::kGive,
                                       LeaseDeed::kTake, LeaseDeed::kRelease, LeaseDeed::kRefuse};
    act(kDeeds[random_.below(kDeeds.size())], who);
  }

  void stop(const OperatorId& who) {
    const auto before = holders();
    EXPECT_TRUE(desk_.admit(OrderKind::kStops, who, any_robots())) << "a stop was lost";
    EXPECT_EQ(holders(), before);
  }

  void steer(const OperatorId& who) {
    const auto robots = any_robots();
    bool may = true;
    for (const auto& robot : robots)
      may = may && (told_[robot].holder.empty() || told_[robot].holder == who.name);
    const auto before = holders();
    const auto done = desk_.admit(OrderKind::kSteers, who, robots);
    EXPECT_EQ(done.ok(), may) << who.name << " steers " << robots.front();
    if (!done) return expect_refused(before, done.error().message);
    for (const auto& robot : robots) EXPECT_EQ(desk_.find(robot)->holder().name, who.name);
  }

  void act(LeaseDeed deed, const OperatorId& who) {
    const auto before = holders();
    const bool says_why = random_.below(3) == 0;
    const auto done = desk_.act(deed, who, any_robots(), says_why ? "because" : "");
    if (!done) expect_refused(before, done.error().message);
  }

  void expect_refused(const std::map<std::string, std::string>& before, const std::string& why) {
    ++refusals_;
    EXPECT_FALSE(why.empty());
    EXPECT_TRUE(why.ends_with('.')) << why;
    EXPECT_EQ(holders(), before) << "it was refused, and something changed";
    EXPECT_TRUE(desk_.take_changes().empty());
  }

  [[nodiscard]] std::map<std::string, std::string> holders() const {
    std::map<std::string, std::string> names;
    for (const auto& [robot, lease] : desk_.leases())
      if (lease.state() != LeaseState::kFree)
        names[robot] = lease.holder().name +
                       (lease.state() == LeaseState::kAsked ? "<" + lease.asker().name : "");
    return names;
  }

  /// Each change must be one that the change before permits.
  void take_in_changes() {
    for (const auto& change : desk_.take_changes()) {
      seen_.insert(change.kind);
      Told& was = told_[change.robot];
      expect_reason(change, was);
      EXPECT_LE(change.at, clock_.now());
      if (change.kind == LeaseChange::Kind::kAsked) was.asked = change.at;
      was.holder = change.holder;
      was.asker = change.asker;
    }
    for (const auto& robot : kRobots) {
      const Lease* lease = desk_.find(robot);
      const bool is_held = lease && lease->state() != LeaseState::kFree;
      EXPECT_EQ(told_[robot].holder, is_held ? lease->holder().name : "") << "was not told";
    }
  }

  void expect_reason(const LeaseChange& change, const Told& was) const {
    using Kind = LeaseChange::Kind;
    switch (change.kind) {
      case Kind::kTaken:
        EXPECT_EQ(was.holder, "");
        break;
      case Kind::kAsked:
        EXPECT_EQ(was.asker, "");
        EXPECT_EQ(change.holder, was.holder);
        break;
      case Kind::kGiven:
      case Kind::kReleased:
        EXPECT_EQ(change.by.name, was.holder);
        EXPECT_EQ(change.holder, was.asker);
        break;
      case Kind::kRefused:
      case Kind::kWithdrawn:
        EXPECT_EQ(change.holder, was.holder);
        EXPECT_NE(was.asker, "");
        break;
      case Kind::kTakenOver:
        EXPECT_EQ(change.other.name, was.holder);
        EXPECT_FALSE(change.reason.empty()) << "all are told why";
        break;
      case Kind::kUnanswered:
        EXPECT_EQ(change.holder, was.asker);
        EXPECT_EQ(change.at, was.asked + Lease::kAnswer);
        break;
      case Kind::kSilent:
        EXPECT_EQ(change.by.name, was.holder);
        EXPECT_GE(change.at - last_word_.at(was.holder), Lease::kSilence);
        EXPECT_EQ(change.holder, was.asker);
        break;
    }
  }

  /// Only the holder may steer. Where nobody holds it, all may, and the first one who does holds
  /// it.
  void expect_one_hand_at_most() const {
    for (const auto& [robot, lease] : desk_.leases()) {
      int may = 0;
      for (int i = 0; i < kOperators; ++i)
        may += lease.may_steer({.name = name(i), .account = "operator", .client = "0"}) ? 1 : 0;
      EXPECT_EQ(may, lease.state() == LeaseState::kFree ? kOperators : 1) << robot;
    }
  }

  void expect_answers_in_time() const {
    for (const auto& [robot, lease] : desk_.leases())
      if (lease.state() == LeaseState::kAsked) {
        EXPECT_GT(lease.passes_at(), clock_.now()) << lease.asker().name << " waits for " << robot;
        EXPECT_FALSE(lease.is_held_by(lease.asker()));
      }
  }

  Random random_;
  SteppedClock clock_;
  LeaseDesk desk_{clock_};
  std::map<std::string, Told> told_;
  std::map<std::string, Time> last_word_;
  std::map<std::string, bool> says_nothing_;
  std::set<LeaseChange::Kind> seen_;
  long refusals_ = 0;
};

TEST(LeaseProperty, NeverTwoHandsNeverALongWaitWhateverFiveOperatorsDo) {
  constexpr std::size_t kKinds = 9;
  Play play(2026);
  play.run(kInterleavings);
  EXPECT_EQ(play.seen().size(), kKinds) << "some kind of change never happened";
  EXPECT_GT(play.refusals(), kInterleavings / 100);
}

}  // namespace
}  // namespace galilean::monitor
