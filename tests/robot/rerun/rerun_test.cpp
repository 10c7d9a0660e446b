// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rerun/rerun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bhdl/check.h"
#include "robot/components.h"
#include "robot/inputs/input_digests.h"
#include "robot/rerun/rerun_report.h"
#include "sim/headless/headless.h"
#include "sim/headless/programs.h"
#include "tests/robot/rerun/recorded_run.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;

const Registry& components() {
  static const Registry registry = [] {
    Registry made;
    add_components(made);
    return made;
  }();
  return registry;
}

bhdl::Program office() {
  return sim::load_program("office_cleanup", components().catalog()).value();
}

/// Returns the office program with one of its texts changed.
bhdl::Program office_with(const std::string& old_text, const std::string& new_text) {
  auto files = office().files;
  bool found = false;
  for (auto& file : files)
    if (const auto at = file.text.find(old_text); at != std::string::npos) {
      file.text.replace(at, old_text.size(), new_text);
      found = true;
    }
  EXPECT_TRUE(found) << old_text;
  return bhdl::check(std::move(files), components().catalog()).program.value();
}

std::vector<msg::TickInputs> record_office(double duration_s) {
  InputsRecorder recorder;
  recorder.memory_each = 90;
  sim::HeadlessOptions options{.robots = 1, .seed = 3, .duration_s = duration_s};
  options.observers = {&recorder};
  auto contest = sim::HeadlessContest::make(sim::load_scenario("office").value(), components(),
                                            office(), options);
  const Executive& executive = contest.value()->robot(0).executive();
  recorder.record({.robot = "io",
                   .seed = executive.seed(),
                   .description = [&](ProgramId id) { return executive.description(id); },
                   .break_table = [](std::uint64_t) { return std::nullopt; }});
  EXPECT_TRUE(contest.value()->run());
  return std::move(recorder.ticks);
}

/// Half a minute of the contest in the office.
const std::vector<msg::TickInputs>& recording() {
  static const auto recorded = record_office(30);
  return recorded;
}

/// Makes the digests fit again, as if the robot had read what stands there now.
void sign(msg::TickInputs& tick) {
  tick.orders_digest = orders_digest(tick);
  tick.board_digest = board_digest(tick);
}

std::size_t tick_in_state(const std::string& state) {
  const auto& ticks = recording();
  for (std::size_t i = 1; i < ticks.size(); ++i)
    if (ticks[i].outcome.state == state && ticks[i - 1].outcome.state == state) return i;
  ADD_FAILURE() << "never in " << state;
  return 0;
}

TEST(Rerun, NoBitOfTheOfficeCleanupDiffers) {
  const auto result = run_again(recording(), components());
  EXPECT_FALSE(result.divergence) << (result.divergence ? result.divergence->cause : "");
  EXPECT_EQ(result.cannot_tell, "");
  EXPECT_EQ(result.ticks, recording().size());
  EXPECT_GT(result.ticks, 600U);
  EXPECT_GT(recording().back().outcome.transitions, 2U) << "the robot does something";
  EXPECT_EQ(exit_code(result), 0);
  EXPECT_THAT(describe({.title = "run.mcap"}, result, 1), HasSubstr("run.mcap: 0 bits differ in"));
}

TEST(Rerun, ABitOfTheBoardsStatusThatIsNotAsItWasReadIsFound) {
  auto ticks = recording();
  ticks[300].left_travel_m = std::nextafter(ticks[300].left_travel_m, 1e9);
  const auto result = run_again(ticks, components());
  EXPECT_EQ(result.untold_tick, 301U);
  EXPECT_THAT(result.cannot_tell, HasSubstr("the board's status"));
  EXPECT_EQ(exit_code(result), 3);
  EXPECT_THAT(describe({}, result, 1), HasSubstr("cannot tell from tick 301"));
}

TEST(Rerun, AnotherBitOfTheBoardsStatusLeadsToAnotherShaft) {
  auto ticks = recording();
  ticks[300].left_travel_m = std::nextafter(ticks[300].left_travel_m, 1e9);
  sign(ticks[300]);
  const auto result = run_again(ticks, components());
  ASSERT_TRUE(result.divergence);
  EXPECT_EQ(result.divergence->tick, ticks[300].tick);
  EXPECT_THAT(result.divergence->cause, HasSubstr("dead reckoning"));
  EXPECT_EQ(exit_code(result), 1);
}

TEST(Rerun, AnotherBumperIsTracedToTheSchemaThatReadsIt) {
  auto ticks = recording();
  const std::size_t at = tick_in_state("move_to_trash");
  ticks[at].bumpers ^= 4;
  sign(ticks[at]);
  const auto result = run_again(ticks, components());
  ASSERT_TRUE(result.divergence);
  EXPECT_EQ(result.divergence->tick, ticks[at].tick);
  EXPECT_THAT(result.divergence->cause, HasSubstr("perceptual schema 'bumper_scanner'"));
}

TEST(Rerun, AnotherTimeIsFound) {
  auto ticks = recording();
  ++ticks[200].now_ns;
  sign(ticks[200]);
  const auto result = run_again(ticks, components());
  ASSERT_TRUE(result.divergence);
  EXPECT_EQ(result.divergence->tick, ticks[200].tick);
}

TEST(Rerun, ADamagedPictureIsToldAndNotUsed) {
  auto ticks = recording();
  for (std::size_t i = 100; i < ticks.size(); ++i) {
    if (ticks[i].picture.empty()) continue;
    ticks[i].picture[ticks[i].picture.size() / 2] ^= 1;
    const auto result = run_again(ticks, components());
    EXPECT_EQ(result.untold_tick, ticks[i].tick);
    EXPECT_THAT(result.cannot_tell, HasSubstr("picture"));
    return;
  }
  FAIL() << "no picture";
}

TEST(Rerun, OfWhatIsBehindAMissingTickNothingIsToldUntilTheNextMemory) {
  auto ticks = recording();
  ticks.erase(ticks.begin() + 50, ticks.begin() + 52);
  const auto result = run_again(ticks, components());
  EXPECT_EQ(result.cannot_tell, "the inputs of 2 ticks are missing");
  EXPECT_EQ(result.untold_tick, 51U);
  EXPECT_EQ(exit_code(result), 3);
  EXPECT_EQ(result.ticks, 50 + ticks.back().tick - 90) << "it goes on from the next memory";
}

TEST(Rerun, ARecordingFromTheMiddleOfARunSaysSo) {
  const auto& ticks = recording();
  const auto result = run_again({ticks.begin() + 20, ticks.begin() + 80}, components());
  EXPECT_EQ(result.ticks, 0U);
  EXPECT_THAT(result.cannot_tell, HasSubstr("begins with tick 21"));
  EXPECT_EQ(exit_code(result), 3);
}

TEST(Rerun, ARunIsTheSameFromEachMemoryOn) {
  const auto& ticks = recording();
  int begun = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    if (ticks[i].memory.empty()) continue;
    const auto end = ticks.begin() + static_cast<std::ptrdiff_t>(std::min(i + 120, ticks.size()));
    const auto result =
        run_again({ticks.begin() + static_cast<std::ptrdiff_t>(i) - 5, end}, components());
    EXPECT_FALSE(result.divergence) << (result.divergence ? result.divergence->cause : "");
    EXPECT_EQ(exit_code(result), i + 1 < ticks.size() ? 0 : 3);
    EXPECT_EQ(result.first_tick, i + 1 < ticks.size() ? ticks[i].tick + 1 : 0);
    EXPECT_EQ(result.left_out, 6U);
    ++begun;
  }
  EXPECT_GE(begun, 6);
}

TEST(Rerun, AMemoryThatIsDamagedIsNotUsed) {
  auto ticks = recording();
  ticks.erase(ticks.begin(), ticks.begin() + 60);
  const auto with =
      std::ranges::find_if(ticks, [](const auto& tick) { return !tick.memory.empty(); });
  ASSERT_NE(with, ticks.end());
  with->memory[0].packed[with->memory[0].packed.size() / 2] ^= 1;
  EXPECT_THAT(run_again(ticks, components()).cannot_tell, HasSubstr("is damaged"));
}

TEST(Rerun, AnotherProgramTakesOverFromAMemory) {
  auto ticks = recording();
  ticks.erase(ticks.begin(), ticks.begin() + 60);
  const auto other =
      office_with("name: \"trash_detector\"", "name: \"trash_detector\" max_range: 1");
  EXPECT_TRUE(run_again(ticks, components(), other).divergence);
}

TEST(Rerun, ATickThatCameTwiceCountsOnce) {
  auto ticks = recording();
  ticks.insert(ticks.begin() + 50, ticks[49]);
  EXPECT_EQ(exit_code(run_again(ticks, components())), 0);
}

TEST(Rerun, TheSameProgramInPlaceOfItselfIsTheSame) {
  EXPECT_EQ(exit_code(run_again(recording(), components(), office())), 0);
}

TEST(Rerun, AnotherProgramIsTracedToTheSchemaThatGoesAnotherWay) {
  const auto other =
      office_with("name: \"trash_detector\"", "name: \"trash_detector\" max_range: 1");
  const auto result = run_again(recording(), components(), other);
  ASSERT_TRUE(result.divergence);
  EXPECT_THAT(result.divergence->cause, HasSubstr("trash_detector"));
  EXPECT_THAT(describe({.other_program = true}, result, 1),
              HasSubstr("recorded bits 'trash_seen'"));
}

}  // namespace
}  // namespace galilean::robot
