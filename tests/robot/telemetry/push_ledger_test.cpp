// SPDX-License-Identifier: BSD-3-Clause
// Events of a program come later than the program. A push is judged by what runs, not by what was
// told.
#include "robot/telemetry/push_ledger.h"

#include <gmock/gmock.h>

#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
namespace status = msg::ProgramReply_Constants;

class PushLedgerTest : public testing::Test {
 protected:
  PushLedgerTest() : ledger(*robot.executive) {
    EXPECT_TRUE(robot.load(text("a")));
    robot.tick();
    EXPECT_THAT(tell(), IsEmpty());
  }
  static std::string text(const std::string& state) { return "state: name: \"" + state + "\" end"; }
  static std::string hash_of(const std::string& state) { return program_of(text(state)).hash; }

  Result<std::vector<msg::ProgramReply>> push(const std::string& id, const std::string& state,
                                              const std::string& replaces = "") {
    auto program = program_of(text(state));
    PushLedger::Push made{id, program.hash, {}};
    return ledger.load(std::move(program), robot.executive->probation_rules(), std::move(made),
                       replaces);
  }
  /// Tells the ledger the events that it has not heard, and returns its answers.
  std::vector<msg::ProgramReply> tell() {
    std::vector<msg::ProgramReply> answers;
    for (; told < robot.events.events.size(); ++told)
      for (auto& answer : ledger.answers(robot.events.events[told]))
        answers.push_back(std::move(answer));
    return answers;
  }

  TestRobot robot;
  PushLedger ledger;
  std::size_t told = 0;
};

TEST_F(PushLedgerTest, OfTwoPushesThatReplaceTheSameProgramTheSecondIsRefused) {
  ASSERT_TRUE(push("first", "b", hash_of("a")));
  robot.tick();
  const auto second = push("second", "c", hash_of("a"));
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, AllOf(HasSubstr(hash_of("a")), HasSubstr(hash_of("b"))));
  const auto answers = tell();
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_EQ(answers[0].id, "first");
  EXPECT_EQ(answers[0].status, status::RUNNING);
}

TEST_F(PushLedgerTest, TheProgramBeforeDoesNotRunAnyMoreAndComesBack) {
  ASSERT_TRUE(push("b", "b"));
  robot.tick();
  EXPECT_EQ(ledger.running_hash(), hash_of("b"));
  const auto back = push("back", "a");
  ASSERT_TRUE(back);
  EXPECT_THAT(back.value(), IsEmpty()) << "it is not running yet";
  robot.tick();
  EXPECT_EQ(robot.state(), "a");
  const auto answers = tell();
  ASSERT_THAT(answers, SizeIs(2));
  EXPECT_EQ(answers[0].id, "b");
  EXPECT_EQ(answers[1].id, "back");
  EXPECT_EQ(answers[1].running_hash, hash_of("a"));
}

TEST_F(PushLedgerTest, APushOfWhatRunsAlreadyIsAnsweredOnceItIsKnownThatItRuns) {
  ASSERT_TRUE(push("first", "b"));
  robot.tick();
  const auto again = push("again", "b", hash_of("b"));
  ASSERT_TRUE(again);
  EXPECT_THAT(again.value(), IsEmpty());
  EXPECT_FALSE(robot.executive->waiting());
  const auto answers = tell();
  ASSERT_THAT(answers, SizeIs(2));
  EXPECT_EQ(answers[0].id, "first");
  EXPECT_EQ(answers[1].id, "again");
  EXPECT_EQ(answers[1].status, status::RUNNING);
  EXPECT_EQ(answers[1].running_hash, hash_of("b"));
  robot.tick(201);
  EXPECT_THAT(tell(), SizeIs(2)) << "both are told that it proved itself";
}

TEST_F(PushLedgerTest, APushOfWhatWasRolledBackToIsAnsweredAfterTheRollback) {
  ASSERT_TRUE(push("b", "b"));
  robot.tick();
  tell();
  ASSERT_TRUE(robot.executive->roll_back(robot.executive->running(), "by anna"));
  robot.tick();
  const auto again = push("again", "a");
  ASSERT_TRUE(again);
  EXPECT_THAT(again.value(), IsEmpty());
  EXPECT_FALSE(robot.executive->waiting());
  const auto answers = tell();
  ASSERT_THAT(answers, SizeIs(3));
  EXPECT_EQ(answers[0].status, status::ROLLED_BACK);
  EXPECT_EQ(answers[1].id, "again");
  EXPECT_EQ(answers[1].status, status::RUNNING);
  EXPECT_EQ(answers[2].status, status::CONFIRMED) << "the first program needs no probation";
}

TEST_F(PushLedgerTest, AnOrderToRollBackIsJudgedByWhatRunsToo) {
  ASSERT_TRUE(push("b", "b"));
  robot.tick();
  const auto of_what_was_told = ledger.roll_back({"order", hash_of("a"), {}}, "by anna");
  ASSERT_FALSE(of_what_was_told);
  EXPECT_THAT(of_what_was_told.error().message,
              HasSubstr("because program " + hash_of("b") + " runs"));
  const auto too_early = ledger.roll_back({"order", hash_of("b"), {}}, "by anna");
  ASSERT_FALSE(too_early);
  EXPECT_THAT(too_early.error().message, HasSubstr("yet"));
  tell();
  ASSERT_TRUE(ledger.roll_back({"order", hash_of("b"), {}}, "by anna"));
  robot.tick();
  EXPECT_EQ(robot.state(), "a");
  const auto answers = tell();
  ASSERT_THAT(answers, SizeIs(2)) << "the push and the order";
  EXPECT_EQ(answers[0].status, status::ROLLED_BACK);
  EXPECT_EQ(answers[1].status, status::ROLLED_BACK);
}

TEST_F(PushLedgerTest, APushOfWhatIsKnownToRunIsAnsweredAtOnce) {
  const auto again = push("again", "a", hash_of("a"));
  ASSERT_TRUE(again);
  ASSERT_THAT(again.value(), SizeIs(2));
  EXPECT_EQ(again.value()[0].message, "it runs already");
  EXPECT_EQ(again.value()[1].status, status::CONFIRMED);
}

}  // namespace
}  // namespace galilean::robot
