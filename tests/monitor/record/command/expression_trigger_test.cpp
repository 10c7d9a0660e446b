// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/command/expression_trigger.h"

#include <gmock/gmock.h>

#include "tests/free_domain.h"
#include "tests/monitor/expect/recording/cdr_text.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;

class ExpressionTriggerTest : public testing::Test {
 protected:
  std::unique_ptr<ExpressionTrigger> trigger(const std::string& text) {
    auto read = ExpressionTrigger::read(text, definitions_);
    EXPECT_TRUE(read) << (read ? "" : read.error().message);
    return read ? std::move(read).value() : nullptr;
  }
  /// Gives it that a robot is in a state.
  void tell(ExpressionTrigger& trigger, double s, const std::string& robot,
            const std::string& name) {
    wire::EndpointInfo writer;
    writer.topic = "rt/" + robot + "/state";
    writer.dds_type = "galilean_msgs::msg::dds_::RobotState_";
    writer.guid = robot;
    state_.robot = robot;
    state_.state = name;
    ++state_.tick;
    const auto cdr = expect::cdr(state_);
    trigger.take(writer, {cdr, 0, 1, state_.tick}, Time{} + from_seconds(s));
  }
  /// Gives it that a robot's program has a state "stuck".
  static void tell_program(ExpressionTrigger& trigger, const std::string& robot) {
    wire::EndpointInfo writer;
    writer.topic = "rt/" + robot + "/program";
    writer.dds_type = "galilean_msgs::msg::dds_::Program_";
    writer.guid = robot + "'s program";
    msg::Program program;
    program.robot = robot;
    program.states.emplace_back().name = "stuck";
    trigger.take(writer, {expect::cdr(program), 0, 1, 1}, Time{});
  }
  std::string refusal(const std::string& text) {
    const auto read = ExpressionTrigger::read(text, definitions_);
    return read ? "" : read.error().message;
  }

 private:
  std::unique_ptr<wire::Participant> participant_ =
      wire::Participant::join("record", free_domain()).value();
  Definitions definitions_{*participant_, [] { return false; }};
  msg::RobotState state_;
};

TEST_F(ExpressionTriggerTest, FiresWhenTheConditionComesTrueForARobot) {
  const auto stuck = trigger("state is \"stuck\"");
  ASSERT_TRUE(stuck);
  tell(*stuck, 0, "io", "wander");
  EXPECT_FALSE(stuck->happened());
  tell(*stuck, 0.1, "io", "stuck");
  EXPECT_THAT(stuck->happened().value_or(""), HasSubstr("io: state is 'stuck'"));
  tell(*stuck, 0.2, "io", "stuck");
  EXPECT_FALSE(stuck->happened()) << "it has not come true again";
  tell(*stuck, 0.3, "europa", "stuck");
  EXPECT_THAT(stuck->happened().value_or(""), HasSubstr("europa"));
  tell(*stuck, 0.4, "io", "wander");
  tell(*stuck, 0.5, "io", "stuck");
  EXPECT_TRUE(stuck->happened());
}

TEST_F(ExpressionTriggerTest, WaitsAsLongAsTheConditionSays) {
  const auto stuck = trigger("state is \"stuck\" for 2 s");
  ASSERT_TRUE(stuck);
  for (int i = 0; i < 20; ++i) tell(*stuck, 0.1 * i, "io", "stuck");
  EXPECT_FALSE(stuck->happened());
  tell(*stuck, 2.1, "io", "stuck");
  EXPECT_TRUE(stuck->happened());
}

TEST_F(ExpressionTriggerTest, RefusesWhatIsNoCondition) {
  EXPECT_THAT(refusal("state are \"stuck\""), HasSubstr("is no condition"));
  EXPECT_THAT(refusal(""), HasSubstr("is no condition"));
  EXPECT_THAT(refusal("state is \"a\", never state is \"b\""),
              HasSubstr("more than one condition"));
  EXPECT_THAT(refusal("state is \"a\"\nio: never state is \"b\""),
              HasSubstr("more than one condition"));
}

TEST_F(ExpressionTriggerTest, DoubtsANameThatARobotsProgramDoesNotHave) {
  const auto mistyped = trigger("state is \"stuk\"");
  ASSERT_TRUE(mistyped);
  EXPECT_THAT(mistyped->doubts(), testing::IsEmpty()) << "no program is known";
  tell_program(*mistyped, "io");
  EXPECT_THAT(mistyped->doubts(), testing::ElementsAre(testing::AllOf(
                                      HasSubstr("--on: io's program has no state"),
                                      HasSubstr("stuk"), HasSubstr("did you mean 'stuck'?"))));
  const auto right = trigger("state is \"stuck\"");
  ASSERT_TRUE(right);
  tell_program(*right, "io");
  EXPECT_THAT(right->doubts(), testing::IsEmpty());
}

TEST_F(ExpressionTriggerTest, WantsTheTopicsThatItsConditionNeeds) {
  const auto fields = trigger("/scan.range < 1");
  ASSERT_TRUE(fields);
  wire::EndpointInfo writer;
  writer.topic = "rt/scan";
  writer.dds_type = "sensor::msg::dds_::Scan_";
  EXPECT_TRUE(fields->wants(writer));
  writer.topic = "rt/io/state";
  writer.dds_type = "galilean_msgs::msg::dds_::RobotState_";
  EXPECT_TRUE(fields->wants(writer)) << "from which robots are known";
  writer.topic = "rt/io/variables";
  writer.dds_type = "galilean_msgs::msg::dds_::Variables_";
  EXPECT_FALSE(fields->wants(writer));
}

}  // namespace
}  // namespace galilean::monitor
