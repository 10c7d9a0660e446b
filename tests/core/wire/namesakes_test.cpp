// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/namesakes.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"

namespace galilean::wire {
namespace {

const std::vector<std::string> kRobotsTopics{robot_topic("io", "state"), kCommandTopic};

/// A process that reads a topic.
struct Process {
  Process(const std::string& name, int domain, const std::string& topic, const char* type)
      : participant(Participant::join(name, domain).value()), reader(*participant, topic, type) {}

  std::unique_ptr<Participant> participant;
  Reader reader;
};

TEST(Namesakes, AreTheOthersOfThatNameThatReadTheTopicsWhileTheyAreThere) {
  const int domain = free_domain();
  const auto own = Participant::join("io", domain).value();
  const auto ganymede = Participant::join("ganymede", domain).value();
  Namesakes namesakes(*own, kRobotsTopics);
  Namesakes of_ganymede(*ganymede, kRobotsTopics);
  EXPECT_EQ(namesakes.count(), 0);
  for (int round = 0; round < 2; ++round) {
    const Process second("io", domain, kRobotsTopics[0], msg::RobotState::kRosType);
    EXPECT_TRUE(wait_until([&] { return namesakes.count() == 1; }));
    {
      const Process third("io", domain, kRobotsTopics[1], msg::Command::kRosType);
      EXPECT_TRUE(wait_until([&] { return namesakes.count() == 2; }));
    }
    EXPECT_TRUE(wait_until([&] { return namesakes.count() == 1; }));
    EXPECT_EQ(of_ganymede.count(), 0);
  }
  EXPECT_TRUE(wait_until([&] { return namesakes.count() == 0; }));
}

TEST(Namesakes, AToolThatIsCalledAsTheRobotIsIsNone) {
  const int domain = free_domain();
  const auto own = Participant::join("io", domain).value();
  Namesakes namesakes(*own, kRobotsTopics);
  const Process tool("io", domain, robot_topic("ganymede", "state"), msg::RobotState::kRosType);
  const Process robot("io", domain, kRobotsTopics[0], msg::RobotState::kRosType);
  EXPECT_TRUE(wait_until([&] { return namesakes.count() == 1; }));
  // Both are known by now: whoever joins is told of all readers that are there.
  const Process last("io", domain, kRobotsTopics[0], msg::RobotState::kRosType);
  EXPECT_TRUE(wait_until([&] { return namesakes.count() >= 2; }));
  EXPECT_EQ(namesakes.count(), 2);
}

}  // namespace
}  // namespace galilean::wire
