// SPDX-License-Identifier: BSD-3-Clause
// The judge, which sees one sample at a time, agrees with an evaluator that sees the whole signal
// and does what docs/EXPECT.md says, word by word.
#include <algorithm>
#include <random>

#include "tests/monitor/expect/judge/scene.h"

namespace galilean::expect {
namespace {

/// From `ms` on, up to the next sample, x and y have these values.
struct Sample {
  int ms = 0;
  double x = 0, y = 0;
};

struct Signal {
  std::vector<Sample> samples;
  int end_ms = 0;

  [[nodiscard]] const Sample& at(int ms) const {
    const auto next = std::ranges::upper_bound(samples, ms, {}, &Sample::ms);
    return *(next - 1);
  }
};

Signal random_signal(std::mt19937& random) {
  Signal signal;
  const int count = 1 + static_cast<int>(random() % 30);
  int now_ms = 0;
  for (int i = 0; i < count; ++i) {
    signal.samples.push_back(
        {now_ms, static_cast<double>(random() % 3), static_cast<double>(random() % 3)});
    now_ms += 1 + static_cast<int>(random() % 1500);
  }
  signal.end_ms = signal.samples.back().ms + static_cast<int>(random() % 1500);
  return signal;
}

/// What is expected: the outcome, and the margin where one is reckoned here.
struct Expected {
  Outcome outcome = Outcome::kHolds;
  std::optional<double> margin;
};

bool low(const Sample& sample) {
  return sample.x < 1;
}
bool high(const Sample& sample) {
  return sample.y > 1;
}

Expected always_low(const Signal& signal, int) {
  Expected expected{Outcome::kHolds, 1e9};
  for (const auto& sample : signal.samples) {
    if (!low(sample)) expected.outcome = Outcome::kFails;
    expected.margin = std::min(*expected.margin, 1 - sample.x);
  }
  return expected;
}

Expected never_low_for(const Signal& signal, int time_ms) {
  int longest_ms = 0;
  for (int begin = 0; begin <= signal.end_ms; ++begin) {
    if (!low(signal.at(begin)) || (begin > 0 && low(signal.at(begin - 1)))) continue;
    int end = begin;
    while (end < signal.end_ms && low(signal.at(end))) ++end;
    longest_ms = std::max(longest_ms, end - begin);
  }
  return {longest_ms >= time_ms ? Outcome::kFails : Outcome::kHolds, (time_ms - longest_ms) * 1e-3};
}

Expected eventually_low(const Signal& signal, int time_ms) {
  for (int ms = 0; ms <= signal.end_ms; ++ms)
    if (low(signal.at(ms)))
      return {ms <= time_ms ? Outcome::kHolds : Outcome::kFails, (time_ms - ms) * 1e-3};
  return {signal.end_ms < time_ms ? Outcome::kCannotTell : Outcome::kFails, {}};
}

/// The monitor sees that a deadline passed once something comes behind it, or at the end.
Expected after_low_high(const Signal& signal, int time_ms) {
  Expected expected;
  for (int ms = 0; ms <= signal.end_ms; ++ms) {
    if (!low(signal.at(ms)) || (ms > 0 && low(signal.at(ms - 1)))) continue;
    int answer = ms;
    while (answer <= signal.end_ms && !high(signal.at(answer))) ++answer;
    const bool in_time = answer <= signal.end_ms && answer <= ms + time_ms;
    if (in_time) continue;
    if (signal.end_ms > ms + time_ms)
      expected.outcome = Outcome::kFails;
    else if (expected.outcome == Outcome::kHolds)
      expected.outcome = Outcome::kCannotTell;
  }
  return expected;
}

Expected low_until_high(const Signal& signal, int time_ms) {
  for (int ms = 0; ms <= signal.end_ms; ++ms) {
    if (ms > time_ms) return {Outcome::kFails, {}};
    if (high(signal.at(ms))) return {Outcome::kHolds, (time_ms - ms) * 1e-3};
    if (!low(signal.at(ms))) return {Outcome::kFails, {}};
  }
  return {Outcome::kCannotTell, {}};
}

Expected at_most_two(const Signal& signal, int time_ms) {
  std::vector<int> rises;
  std::size_t most = 0;
  for (int ms = 0; ms <= signal.end_ms; ++ms) {
    if (!low(signal.at(ms)) || (ms > 0 && low(signal.at(ms - 1)))) continue;
    rises.push_back(ms);
    most = std::max(most, static_cast<std::size_t>(std::ranges::count_if(
                              rises, [&](int each) { return each >= ms - time_ms; })));
  }
  return {most > 2 ? Outcome::kFails : Outcome::kHolds, {}};
}

using Naive = Expected (*)(const Signal&, int);

/// Compares the two on many signals. `text` has TIME where the time stands.
void agree(const std::string& text, Naive naive) {
  std::mt19937 random(7);
  int fails = 0;
  for (int round = 0; round < 400 && fails < 3; ++round) {
    const Signal signal = random_signal(random);
    const int time_ms = 1 + static_cast<int>(random() % 4000);
    std::string claim = text;
    if (const auto at = claim.find("TIME"); at != std::string::npos)
      claim.replace(at, 4, std::to_string(time_ms) + " ms");
    Scene scene(claim);
    for (const auto& sample : signal.samples) {
      scene.robot().x_m = sample.x;
      scene.robot().y_m = sample.y;
      scene.send_state(sample.ms * 1e-3);
    }
    const auto finding = scene.finding(signal.end_ms * 1e-3);
    const auto expected = naive(signal, time_ms);
    bool same = finding.outcome == expected.outcome;
    if (expected.margin && expected.outcome != Outcome::kCannotTell)
      same = same && finding.margin && std::abs(*finding.margin - *expected.margin) < 1e-5;
    if (same) continue;
    ++fails;
    ADD_FAILURE() << claim << " in round " << round << ": outcome "
                  << static_cast<int>(finding.outcome) << ", expected "
                  << static_cast<int>(expected.outcome) << ", margin "
                  << finding.margin.value_or(-99) << ", expected " << expected.margin.value_or(-99);
  }
}

TEST(JudgeProperty, Always) {
  agree("io: always x < 1 m", always_low);
}
TEST(JudgeProperty, NeverFor) {
  agree("io: never x < 1 m for TIME", never_low_for);
}
TEST(JudgeProperty, Eventually) {
  agree("io: eventually within TIME x < 1 m", eventually_low);
}
TEST(JudgeProperty, After) {
  agree("io: after x < 1 m, within TIME y > 1 m", after_low_high);
}
TEST(JudgeProperty, Until) {
  agree("io: x < 1 m until y > 1 m within TIME", low_until_high);
}
TEST(JudgeProperty, CountInAnyWindow) {
  agree("io: count of (x < 1 m) in any TIME <= 2", at_most_two);
}

TEST(JudgeProperty, CertaintyIsJudgedAtEveryInstantOfItsDecay) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    Scene scene("io: always certainty of trash >= 0.5");
    scene.state(0, "a");
    double now_s = 0, least = 1;
    const int count = 1 + static_cast<int>(random() % 10);
    for (int i = 0; i < count; ++i) {
      const double certainty = static_cast<double>(random() % 5) * 0.25;
      const double decay_per_s = static_cast<double>(random() % 4) * 0.125;
      const double lasts_s = 0.125 * static_cast<double>(1 + random() % 12);
      scene.trash(now_s, certainty, decay_per_s);
      least = std::min(least, std::max(0.0, certainty - decay_per_s * lasts_s));
      now_s += lasts_s;
    }
    const auto finding = scene.finding(now_s);
    EXPECT_EQ(finding.outcome, least >= 0.5 - 1e-9 ? Outcome::kHolds : Outcome::kFails) << round;
    EXPECT_NEAR(finding.margin.value_or(-99), least - 0.5, 1e-6) << round;
  }
}

}  // namespace
}  // namespace galilean::expect
