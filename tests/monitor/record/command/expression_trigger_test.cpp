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

}  // namespace
}  // namespace galilean::monitor
