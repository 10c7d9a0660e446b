// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/doctor/intake_check.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace galilean::front {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

json refused(const std::string& topic, unsigned messages) {
  return {{"topic", topic}, {"reason", "RobotState.tick is missing"}, {"messages", messages}};
}

TEST(IntakeCheck, IsWellWhereAllWasTaken) {
  EXPECT_TRUE(intake_check({{"refused_messages", json::array()}}).ok);
}

TEST(IntakeCheck, SaysTopicReasonAndCountAndWhatToDo) {
  const auto check = intake_check(
      {{"refused_messages", json::array({refused("rt/io/state", 12), refused("(others)", 1)})}});
  EXPECT_FALSE(check.ok);
  EXPECT_EQ(check.told,
            "12 messages on /io/state were not taken: RobotState.tick is missing; "
            "1 message was not taken: RobotState.tick is missing");
  EXPECT_THAT(check.to_do, HasSubstr("galilean info"));
}

TEST(IntakeCheck, OfManyTellsTheMostAndCountsTheRest) {
  auto list = json::array();
  for (unsigned i = 1; i <= 5; ++i)
    list.push_back(refused("rt/r" + std::to_string(i) + "/state", i));
  const auto told = intake_check({{"refused_messages", list}}).told;
  EXPECT_THAT(told, HasSubstr("5 messages on /r5/state"));
  EXPECT_THAT(told, HasSubstr("and of 2 more kinds"));
  EXPECT_THAT(told, Not(HasSubstr("/r1/")));
}

TEST(IntakeCheck, TakesWhateverAnswersForNoRefusal) {
  for (const auto& answer : {json(), json(3), json::array({1}), json{{"refused_messages", 7}},
                             json{{"refused_messages", json::array({1, json::object()})}},
                             json{{"refused_messages", json::array({{{"topic", 1}}})}}})
    EXPECT_TRUE(intake_check(answer).ok) << answer;
}

}  // namespace
}  // namespace galilean::front
