// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/motor/force_test.h"

namespace galilean::robot {
namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<double>;

class CombineForcesTest : public ForceTest {
 protected:
  CombineForcesTest() {
    for (const char* name : {"a", "b"}) variable<Force>(name).constant = false;
  }
  std::unique_ptr<Schema> schema(Numbers gains, const std::string& mode = "sum",
                                 double max_length = 1) {
    return make("combine_forces", {{"inputs", Names{"a", "b"}},
                                   {"gains", std::move(gains)},
                                   {"mode", mode},
                                   {"max_length", max_length},
                                   {"result", "result"s}});
  }
  void write(const std::string& name, Vec2 force, double certainty = 1) {
    variable<Force>(name).write({force}, certainty, tick.now, tick.number);
  }
};

TEST_F(CombineForcesTest, SumsGainTimesForce) {
  write("a", {0.1, 0});
  write("b", {0, 0.2});
  schema({2, 3})->run(tick);
  expect_near(result().value.value, {0.2, 0.6});
}

TEST_F(CombineForcesTest, AveragesByTheGains) {
  write("a", {1, 0});
  write("b", {0, 1});
  schema({1, 3}, "average")->run(tick);
  expect_near(result().value.value, {0.25, 0.75});
}

TEST_F(CombineForcesTest, ClipsTheLengthAndKeepsTheDirection) {
  write("a", {3, 4});
  schema({1, 1})->run(tick);
  expect_near(result().value.value, {0.6, 0.8});
  schema({1, 1}, "sum", 2)->run(tick);
  expect_near(result().value.value, {1.2, 1.6});
  write("a", {0.6, 0.8});
  schema({1, 1})->run(tick);
  expect_near(result().value.value, {0.6, 0.8});
}

TEST_F(CombineForcesTest, LeavesOutWhatDidNotRunInThisTick) {
  const auto combine = schema({1, 1});
  write("a", {0.5, 0});
  advance();
  write("b", {0, 0.5});
  combine->run(tick);
  expect_near(result().value.value, {0, 0.5});
}

TEST_F(CombineForcesTest, CountsAConstantForEver) {
  const auto combine = schema({1, 1});
  write("a", {0, -0.5});
  variable<Force>("a").constant = true;
  advance(3600);
  combine->run(tick);
  expect_near(result().value.value, {0, -0.5});
}

TEST_F(CombineForcesTest, IsSilentWhereNothingActs) {
  const auto combine = schema({1, 1});
  expect_silence(*combine);
  variable<Force>("a").constant = true;  // but never valid
  expect_silence(*combine);
}

TEST_F(CombineForcesTest, IsAsSureAsWhatItIsMadeOf) {
  write("a", {0.3, 0}, 1);
  write("b", {0.1, 0}, 0.2);
  schema({1, 1})->run(tick);
  EXPECT_NEAR(result().reliability.certainty, 0.8, kTolerance);
  write("a", {0, 0}, 1);
  write("b", {0, 0}, 0.2);
  schema({1, 1})->run(tick);
  EXPECT_NEAR(result().reliability.certainty, 0.6, kTolerance);
}

}  // namespace
}  // namespace galilean::robot
