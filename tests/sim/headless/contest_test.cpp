// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "robot/components.h"
#include "sim/headless/headless.h"
#include "sim/headless/programs.h"
#include "sim/headless/report.h"

namespace galilean::sim {
namespace {

const Registry& components() {
  static const Registry registry = [] {
    Registry made;
    robot::add_components(made);
    return made;
  }();
  return registry;
}

bhdl::Program program(const std::string& name = "office_cleanup") {
  auto loaded = load_program(name, components().catalog());
  if (!loaded) throw std::runtime_error(loaded.error().message);
  return std::move(loaded).value();
}

std::unique_ptr<HeadlessContest> contest(const std::string& scenario, HeadlessOptions options) {
  auto made =
      HeadlessContest::make(load_scenario(scenario).value(), components(), program(), options);
  if (!made) throw std::runtime_error(made.error().message);
  const auto done = made.value()->run();
  if (!done) throw std::runtime_error(done.error().message);
  return std::move(made).value();
}

TEST(Contest, SameSeedSameHashAndAnotherSeedAnother) {
  const auto hash = [](std::uint64_t seed) {
    return contest("office", {.robots = 3, .seed = seed, .duration_s = 30})->hash();
  };
  const std::uint64_t first = hash(1);
  EXPECT_EQ(hash(1), first);
  EXPECT_NE(hash(2), first);
}

TEST(Contest, TheSameOrdersBeforeTheSameStepsGiveTheSameHash) {
  const auto hash = [](std::uint64_t step) {
    HeadlessOptions options{.robots = 2, .seed = 1, .duration_s = 20};
    msg::SimulationOrder push, broken;
    push.order = "push";
    push.subject = "io";
    push.impulse_ns = 5;
    broken.order = "break";
    broken.subject = "ganymede";
    broken.part = "serial_line";
    options.orders = {{step, push}, {step + 300, broken}};
    broken.order = "mend";
    options.orders.push_back({step + 500, broken});
    return contest("office", options)->hash();
  };
  const std::uint64_t first = hash(500);
  EXPECT_EQ(hash(500), first);
  EXPECT_NE(hash(501), first);
  EXPECT_NE(contest("office", {.robots = 2, .seed = 1, .duration_s = 20})->hash(), first);
}

TEST(Contest, AnOrderThatCannotBeCarriedOutEndsTheRun) {
  HeadlessOptions options{.robots = 1, .seed = 1, .duration_s = 5};
  msg::SimulationOrder order;
  order.order = "jump";
  options.orders = {{10, order}};
  auto made =
      HeadlessContest::make(load_scenario("office").value(), components(), program(), options);
  ASSERT_TRUE(made);
  EXPECT_FALSE(made.value()->run());
}

// Every compiler must agree on them: who changes what happens in a contest changes them on purpose.
TEST(Contest, EndsInTheKnownStateWithEveryCompiler) {
  constexpr std::array<std::uint64_t, 5> kKnown{0x56718f583e863c12, 0x59352ce28358854b,
                                                0x3044a479c78f828b, 0xcfd57ab2b3093190,
                                                0xc5ce0e2e168be5a4};
  for (std::size_t i = 0; i < kKnown.size(); ++i) {
    const auto done = contest("office", {.robots = 3, .seed = i + 1, .duration_s = 30});
    EXPECT_EQ(done->hash(), kKnown[i]) << "seed " << i + 1 << std::hex << ": 0x" << done->hash();
  }
}

TEST(Contest, ARobotCleansThePracticeRoom) {
  const auto done = contest("practice", {.robots = 1, .seed = 1, .duration_s = 180});
  EXPECT_GE(done->world().referee().deposited(), 4U);
  EXPECT_LE(done->world().referee().collisions(), 5U);
  EXPECT_EQ(done->world().referee().phase(), Phase::kOver);
  EXPECT_NEAR(done->simulated_s(), 180, 0.02);
}

TEST(Contest, DeadReckoningDriftsButNotBeyondUse) {
  const auto done = contest("office", {.robots = 1, .seed = 1, .duration_s = 60});
  const RobotStatistics statistics = done->robot(0).statistics();
  EXPECT_GT(statistics.distance_m, 10);
  EXPECT_GT(statistics.drift_m, 0.001 * statistics.distance_m);
  EXPECT_LT(statistics.drift_m, 0.03 * statistics.distance_m);
}

TEST(Contest, ReportAndTraceSayWhatHappened) {
  std::ostringstream trace;
  HeadlessOptions options{.robots = 2, .seed = 4, .duration_s = 10, .trace = &trace};
  const auto done = contest("office", options);
  const auto json = report(*done, options, program(), 0.5);
  EXPECT_EQ(json["pieces"], 24);
  EXPECT_EQ(json["robots"].size(), 2U);
  EXPECT_EQ(json["robots"][1]["name"], "ganymede");
  EXPECT_EQ(json["hash"].get<std::string>().size(), 16U);
  double seconds = 0;
  for (const auto& [state, spent_s] : json["robots"][0]["seconds_in_state"].items())
    seconds += spent_s.get<double>();
  EXPECT_NEAR(seconds, 10, 0.1);

  std::istringstream lines(trace.str());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_TRUE(nlohmann::json::parse(line).contains("state"));
  EXPECT_EQ(count, 20);
}

TEST(StuckWatch, CountsStandingStillWhileTryingOnly) {
  StuckWatch watch;
  const auto stand = [&](const Pose2& pose, bool trying, int steps) {
    for (int i = 0; i < steps; ++i) watch.see(pose, trying, 0.01);
  };
  stand({{1, 1}, 0}, true, 200);
  EXPECT_NEAR(watch.longest_s(), 2, 0.05);
  stand({{1, 1}, 0}, false, 500);
  EXPECT_EQ(watch.stuck_s(), 0);
  stand({{1, 1}, 0.3}, true, 100);
  stand({{1.04, 1}, 0.3}, true, 150);
  EXPECT_NEAR(watch.longest_s(), 2.5, 0.05);
}

}  // namespace
}  // namespace galilean::sim
