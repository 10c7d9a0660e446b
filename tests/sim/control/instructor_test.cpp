// SPDX-License-Identifier: BSD-3-Clause
#include "sim/control/instructor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/control/truth.h"
#include "tests/sim/scenes.h"

namespace galilean::sim {
namespace {

/// A bare floor with two robots, a can and a basket, and an instructor.
class InstructorTest : public testing::Test {
 protected:
  static Scenario scenario() {
    Scenario made = bare_floor();
    made.starts.push_back({{1, 1}, 0});
    made.placed = {{PieceKind::kCan, {4, 4}}};
    made.baskets_m = {{5, 1}};
    made.furniture = {{FurnitureKind::kTable, {{1, 5}, 0}, {1, 1}, 0.74}};
    return made;
  }
  static msg::SimulationOrder order(const std::string& what, const std::string& subject = {}) {
    msg::SimulationOrder made;
    made.order = what;
    made.subject = subject;
    return made;
  }
  static msg::SimulationOrder at(const std::string& what, const std::string& subject, double x_m,
                                 double y_m) {
    auto made = order(what, subject);
    made.x_m = x_m;
    made.y_m = y_m;
    return made;
  }
  static msg::SimulationOrder on_part(const std::string& what, const std::string& part,
                                      const std::string& fault = {}) {
    auto made = order(what, "io");
    made.part = part;
    made.fault = fault;
    return made;
  }
  std::string done(const msg::SimulationOrder& given) {
    const auto answer = instructor.carry_out(given);
    EXPECT_TRUE(answer) << answer.error().message;
    return answer ? answer.value() : "";
  }
  std::string refused(const msg::SimulationOrder& given) {
    const auto before = truth_of(*world, pace);
    const auto answer = instructor.carry_out(given);
    EXPECT_FALSE(answer) << given.order;
    EXPECT_EQ(truth_of(*world, pace), before) << given.order;
    return answer ? "" : answer.error().message;
  }
  void run_for(double seconds) {
    for (int i = 0; i < seconds / World::kStep_s; ++i) {
      contest.before_step();
      world->step();
    }
  }
  const msg::SimulationBody* seen(const std::string& name) {
    truth = truth_of(*world, pace);
    for (const auto& body : truth.bodies)
      if (body.name == name) return &body;
    return nullptr;
  }

  std::unique_ptr<World> world = world_of(scenario());
  Pace pace;
  ContestStart contest{*world};
  Instructor instructor{*world, pace, contest};
  msg::SimulationState truth;
};

TEST_F(InstructorTest, PausesGoesOnAndRefusesBothTwice) {
  EXPECT_EQ(done(order("pause")), "paused the simulation");
  EXPECT_FALSE(pace.take_step());
  EXPECT_NE(refused(order("pause")).find("paused already"), std::string::npos);
  done(order("go_on"));
  EXPECT_TRUE(pace.take_step());
  EXPECT_NE(refused(order("go_on")).find("not paused"), std::string::npos);
}

TEST_F(InstructorTest, AStepIsSoManyStepsAndThenAPause) {
  done(order("pause"));
  auto step = order("step");
  step.duration_s = 0.05;
  done(step);
  int steps = 0;
  while (steps < 100 && pace.take_step()) ++steps;
  EXPECT_EQ(steps, 5);
  EXPECT_TRUE(pace.paused());
  for (const double wrong : {0.0, -1.0, 3601.0, std::nan("")}) {
    step.duration_s = wrong;
    EXPECT_NE(refused(step).find("out of range"), std::string::npos);
  }
}

TEST_F(InstructorTest, ARateChangesHowLongAStepTakes) {
  auto rate = order("rate");
  rate.rate = 4;
  EXPECT_EQ(done(rate), "set the rate to 4");
  EXPECT_EQ(pace.real_time(std::chrono::milliseconds(10)), std::chrono::microseconds(2500));
  for (const double wrong : {0.05, 21.0, -1.0, std::nan("")}) {
    rate.rate = wrong;
    EXPECT_NE(refused(rate).find("expected 0.1 to 20"), std::string::npos);
  }
}

TEST_F(InstructorTest, MovesARobotWithItsHeadingAndAThingWithAnother) {
  EXPECT_EQ(done(at("move", "io", 2, 3.5)), "moved io to (2.00, 3.50) m");
  EXPECT_NEAR(world->robot(0).pose().position_m.x(), 2, 1e-6);
  EXPECT_NEAR(world->robot(0).pose().heading_rad, 0, 1e-6);
  auto turned = at("move", "ganymede", 2, 1);
  turned.turns = true;
  turned.heading_rad = kPi / 2;
  done(turned);
  EXPECT_NEAR(world->robot(1).pose().heading_rad, kPi / 2, 1e-6);
  for (const double wrong : {1e300, -1e300, std::nan("")}) {
    turned.heading_rad = wrong;
    EXPECT_EQ(refused(turned), "the heading is no angle");
  }
  EXPECT_NEAR(world->robot(1).pose().heading_rad, kPi / 2, 1e-6);
  done(at("move", "can_1", 4, 2));
  ASSERT_TRUE(seen("can_1"));
  EXPECT_NEAR(seen("can_1")->y_m, 2, 1e-6);
}

TEST_F(InstructorTest, RefusesAPlaceThatIsTakenOrOutsideAndNamesWhatStandsThere) {
  EXPECT_NE(refused(at("move", "io", 1, 5)).find("table_1"), std::string::npos);
  EXPECT_NE(refused(at("move", "io", 0.05, 3)).find("wall"), std::string::npos);
  EXPECT_NE(refused(at("move", "io", 1, 1)).find("ganymede"), std::string::npos);
  EXPECT_NE(refused(at("move", "io", 7, 3)).find("outside of the arena"), std::string::npos);
  EXPECT_NE(refused(at("move", "io", std::nan(""), 3)).find("outside"), std::string::npos);
  EXPECT_NE(refused(at("move", "europa", 2, 2)).find("'europa'"), std::string::npos);
  EXPECT_NE(refused(at("move", "table_1", 2, 2)).find("'table_1'"), std::string::npos);
}

TEST_F(InstructorTest, AMovedRobotLetsGoAndThatIsNoThrow) {
  done(at("move", "can_1", 3 + Gripper::kPocket_m, 3));
  done(at("move", "basket_1", 3.6, 3.3));
  world->referee().start();
  run(*world, {0, 0, 1000}, 0.5);
  ASSERT_EQ(seen("can_1")->held_by, "io");
  done(at("move", "io", 2, 2));
  run(*world, {0, 0, 1000}, 0.1);
  ASSERT_TRUE(seen("can_1"));
  EXPECT_EQ(seen("can_1")->held_by, "");
  EXPECT_EQ(world->referee().deposited(), 0U);
}

TEST_F(InstructorTest, PushesARobotWhereItIsTold) {
  auto push = order("push", "io");
  push.impulse_ns = 9;
  push.heading_rad = kPi / 2;
  done(push);
  run_for(1);
  EXPECT_GT(world->robot(0).pose().position_m.y(), 3.1);
  EXPECT_NEAR(world->robot(0).pose().position_m.x(), 3, 0.02);
  for (const double wrong : {0.0, -1.0, 21.0, std::nan("")}) {
    push.impulse_ns = wrong;
    EXPECT_NE(refused(push).find("out of range"), std::string::npos);
  }
  push.subject = "can_1";
  EXPECT_NE(refused(push).find("the robots are io, ganymede"), std::string::npos);
}

TEST_F(InstructorTest, PushesThatAddUpDriveNoRobotThroughAWall) {
  auto push = order("push", "io");
  push.impulse_ns = 20;
  push.heading_rad = kPi / 2;
  int pushed = 0;
  std::string why;
  for (int i = 0; i < 100 && why.empty(); ++i) {
    const auto answer = instructor.carry_out(push);
    if (answer)
      ++pushed;
    else
      why = answer.error().message;
  }
  EXPECT_GT(pushed, 0);
  EXPECT_NE(why.find("expected at most 5 m/s"), std::string::npos) << why;
  run_for(3);
  EXPECT_LT(world->robot(0).pose().position_m.y(), world->scenario().arena.depth_m);
}

TEST_F(InstructorTest, DropsAndRemovesPieces) {
  EXPECT_EQ(done(at("drop", "cup", 2, 4)), "dropped cup_2 at (2.00, 4.00) m");
  ASSERT_TRUE(seen("cup_2"));
  EXPECT_EQ(seen("cup_2")->kind, "cup");
  EXPECT_NE(refused(at("drop", "can", 3, 3)).find("io"), std::string::npos);
  EXPECT_NE(refused(at("drop", "can", 6.5, 3)).find("outside"), std::string::npos);
  EXPECT_NE(refused(at("drop", "cow", 2, 2)).find("expected can, cup or wad"), std::string::npos);
  EXPECT_EQ(done(order("remove", "can_1")), "removed can_1");
  EXPECT_FALSE(seen("can_1"));
  EXPECT_NE(refused(order("remove", "can_1")).find("'can_1'"), std::string::npos);
  EXPECT_NE(refused(order("remove", "basket_1")).find("only cans"), std::string::npos);
  run_for(0.1);
}

TEST_F(InstructorTest, BreaksAndMendsBumpersAndWheels) {
  done(on_part("break", "bumper_3", "stuck"));
  EXPECT_EQ(world->robot(0).inputs().bumpers, 0b1000);
  done(on_part("break", "bumper_0"));
  world->robot(0).push_bumpers(1);
  EXPECT_EQ(world->robot(0).inputs().bumpers, 0b1000);
  done(on_part("mend", "bumper_0"));
  EXPECT_EQ(world->robot(0).inputs().bumpers, 0b1001);
  done(on_part("break", "left_wheel"));
  run(*world, {800, 800, 0}, 1);
  EXPECT_GT(world->robot(0).pose().heading_rad, 0.3);
  done(on_part("break", "camera"));
  const auto faults = truth_of(*world, pace).faults;
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(faults[0].part, "camera");
  EXPECT_EQ(faults[2].fault, "stuck");
  done(on_part("break", "board"));
  EXPECT_TRUE(world->robot(0).broken().board);
  done(on_part("mend", "board"));
  EXPECT_FALSE(world->robot(0).broken().board);
}

TEST_F(InstructorTest, RefusesPartsAndFaultsThatThereAreNot) {
  EXPECT_NE(refused(on_part("break", "bumper_8")).find("'bumper_8'"), std::string::npos);
  EXPECT_NE(refused(on_part("break", "camera", "stuck")).find("cannot be stuck"),
            std::string::npos);
  EXPECT_NE(refused(on_part("break", "bumper_1", "wet")).find("'wet'"), std::string::npos);
  EXPECT_NE(refused(on_part("mend", "camera")).find("not broken"), std::string::npos);
}

TEST_F(InstructorTest, StartsPausesAndGoesOnWithTheContest) {
  EXPECT_NE(refused(order("pause_contest")).find("waiting"), std::string::npos);
  EXPECT_EQ(done(order("start_contest")), "started the contest");
  run_for(0.3);
  EXPECT_EQ(world->robot(0).inputs().bumpers, 1);
  run_for(0.3);
  EXPECT_EQ(world->robot(0).inputs().bumpers, 0);
  EXPECT_NE(refused(order("start_contest")).find("runs already"), std::string::npos);
  const double elapsed_s = world->referee().elapsed_s();
  EXPECT_NEAR(elapsed_s, 0.6, 0.021);
  done(order("pause_contest"));
  run_for(1);
  EXPECT_EQ(world->referee().elapsed_s(), elapsed_s);
  EXPECT_EQ(done(order("start_contest")), "let the contest go on");
  EXPECT_EQ(world->referee().phase(), Phase::kRunning);
}

TEST_F(InstructorTest, AResetPutsEverythingBackAndKeepsWhatIsBroken) {
  auto first = truth_of(*world, pace);
  done(order("start_contest"));
  done(on_part("break", "right_wheel"));
  done(order("remove", "can_1"));
  done(at("drop", "wad", 2, 4));
  done(at("move", "io", 5, 5));
  done(at("move", "basket_1", 4, 4.8));
  run_for(1);
  done(order("reset_contest"));
  first.faults = {{"io", "right_wheel", "dead"}};
  EXPECT_EQ(truth_of(*world, pace), first);
  EXPECT_EQ(world->referee().elapsed_s(), 0);
  run_for(0.1);
}

TEST_F(InstructorTest, RefusesAnOrderThatThereIsNot) {
  EXPECT_NE(refused(order("jump")).find("expected one of pause, go_on, step"), std::string::npos);
}

}  // namespace
}  // namespace galilean::sim
