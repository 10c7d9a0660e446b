// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <limits>
#include <numeric>
#include <set>

#include "core/wire/delivery.h"
#include "core/wire/discovery.h"
#include "core/wire/graph.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/refusals.h"
#include "core/wire/ros_time.h"
#include "core/wire/schemas.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"

namespace galilean::wire {
namespace {

const int kDomain = free_domain();
constexpr const char* kStateType = msg::RobotState::kRosType;

std::unique_ptr<Participant> join(const std::string& name = "test") {
  auto joined = Participant::join(name, kDomain);
  if (!joined) throw std::runtime_error(joined.error().message);
  return std::move(joined).value();
}

msg::RobotState state_of(const std::string& robot, std::uint64_t tick) {
  msg::RobotState state;
  state.robot = robot;
  state.tick = tick;
  state.x_m = 1.5;
  state.problems = {"camera: lost", ""};
  return state;
}

std::vector<msg::RobotState> take(Reader& reader) {
  std::vector<msg::RobotState> states;
  reader.take([&](const Received& received) {
    EXPECT_TRUE(msg::decode_cdr(received.cdr, states.emplace_back()));
  });
  return states;
}

TEST(Wire, ALateJoinerLearnsTheNewestStateAtOnce) {
  const auto robot = join("io");
  Writer<msg::RobotState> writer(*robot, robot_topic("io", "state"));
  for (std::uint64_t tick = 1; tick <= 3; ++tick) ASSERT_TRUE(writer.write(state_of("io", tick)));

  const auto monitor = join("monitor");
  Reader reader(*monitor, robot_topic("io", "state"), kStateType);
  std::vector<msg::RobotState> got;
  ASSERT_TRUE(wait_until([&] { return !(got = take(reader)).empty(); }));
  EXPECT_EQ(got, std::vector{state_of("io", 3)});
}

msg::Transition transition_of(const std::string& robot, std::uint64_t number) {
  msg::Transition transition;
  transition.robot = robot;
  transition.number = number;
  return transition;
}

/// Takes transitions until so many have come, and returns their numbers.
std::vector<std::uint64_t> await_numbers(Reader& reader, std::size_t count) {
  std::vector<std::uint64_t> numbers;
  EXPECT_TRUE(wait_until([&] {
    reader.take([&](const Received& received) {
      msg::Transition transition;
      EXPECT_TRUE(msg::decode_cdr(received.cdr, transition));
      numbers.push_back(transition.number);
    });
    return numbers.size() >= count;
  }));
  return numbers;
}

TEST(Wire, ARobotsJournalReachesEachReaderThatIsConnectedAnewAndIsBounded) {
  constexpr std::uint64_t kBeyond = 10;
  const auto robot = join("io");
  Writer<msg::Transition> writer(*robot, robot_topic("journal", "transition"));
  for (std::uint64_t number = 1; number <= kBeyond + kJournalDepth; ++number)
    ASSERT_TRUE(writer.write(transition_of("journal", number)));
  std::vector<std::uint64_t> kept(kJournalDepth);
  std::iota(kept.begin(), kept.end(), kBeyond + 1);
  const auto monitor = join("monitor");
  Reader first(*monitor, robot_topic("journal", "transition"), msg::Transition::kRosType);
  EXPECT_EQ(await_numbers(first, kept.size()), kept);
  const auto recorder = join("record");
  Reader second(*recorder, robot_topic("journal", "transition"), msg::Transition::kRosType,
                Numbered{});
  EXPECT_EQ(await_numbers(second, kept.size()), kept);
}

TEST(Wire, ANumberedReaderChecksBoundsAndNamesItsWriter) {
  const auto robot = join("io");
  Writer<msg::RobotState> writer(*robot, "rt/numbered/state");
  const auto monitor = join("monitor");
  Reader reader(*monitor, "rt/numbered/state", kStateType, Numbered{});
  auto broken = state_of("numbered", 1);
  broken.x_m = std::numeric_limits<double>::infinity();
  ASSERT_TRUE(writer.write(broken));
  std::string robot_name, guid;
  const auto note = [&](const Received& received) {
    robot_name = received.robot;
    guid = reader.guid_of(received.writer);
  };
  ASSERT_TRUE(wait_until([&] {
    reader.take(note);
    return !monitor->refusals().counts().empty();
  }));
  EXPECT_EQ(robot_name, "");
  ASSERT_TRUE(writer.write(state_of("numbered", 2)));
  ASSERT_TRUE(wait_until([&] {
    reader.take(note);
    return !robot_name.empty();
  }));
  EXPECT_EQ(robot_name, "numbered");
  EXPECT_EQ(guid.size(), 32U);
  EXPECT_EQ(reader.guid_of(0), "");
}

TEST(Wire, AReaderTakesOnAfterItsReceiverThrew) {
  const auto robot = join("io");
  Writer<msg::RobotState> writer(*robot, robot_topic("io", "state"));
  Reader reader(*robot, robot_topic("io", "state"), kStateType);
  ASSERT_TRUE(writer.write(state_of("io", 1)));
  ASSERT_TRUE(wait_until([&] {
    try {
      reader.take([](const Received&) { throw std::runtime_error("no paper"); });
      return false;
    } catch (const std::runtime_error&) {
      return true;
    }
  }));
  ASSERT_TRUE(writer.write(state_of("io", 2)));
  std::vector<msg::RobotState> got;
  ASSERT_TRUE(wait_until([&] { return !(got = take(reader)).empty(); }));
  EXPECT_EQ(got, std::vector{state_of("io", 2)});
}

TEST(Wire, AReaderHandsOverNoMessageThatIsOutsideOfItsBounds) {
  const auto robot = join("io");
  Writer<msg::RobotState> writer(*robot, "rt/bounded/state");
  const auto monitor = join("monitor");
  std::vector<std::string> told;
  monitor->refusals().tell_with([&](const std::string& sentence) { told.push_back(sentence); });
  Reader reader(*monitor, "rt/bounded/state", kStateType);
  auto broken = state_of("io", 1);
  broken.x_m = std::numeric_limits<double>::infinity();
  ASSERT_TRUE(writer.write(broken));
  std::size_t got = 0;
  ASSERT_TRUE(wait_until([&] {
    reader.take([&](const Received&) { ++got; });
    return !monitor->refusals().counts().empty();
  }));
  EXPECT_EQ(got, 0U);
  EXPECT_EQ(monitor->refusals().counts()[0].topic, "rt/bounded/state");
  EXPECT_EQ(told.size(), 1U);
  ASSERT_TRUE(writer.write(state_of("io", 2)));
  std::string from;
  ASSERT_TRUE(wait_until([&] {
    reader.take([&](const Received& received) { from = received.robot; });
    return !from.empty();
  }));
  EXPECT_EQ(from, "io");
}

TEST(Wire, DiscoveryTellsWhatIsNewInPortions) {
  const auto robot = join("io");
  std::deque<Writer<msg::RobotState>> writers;
  constexpr std::size_t kWriters = 20;
  for (std::size_t i = 0; i < kWriters; ++i)
    writers.emplace_back(*robot, "rt/portion_" + std::to_string(i) + "/state");
  const auto monitor = join("monitor");
  Discovery discovery(*monitor);
  std::set<std::string> topics;
  ASSERT_TRUE(wait_until([&] {
    const auto fresh = discovery.take_new(3);
    EXPECT_LE(fresh.publications.size(), 3U);
    for (const auto& publication : fresh.publications) {
      if (!publication.topic.starts_with("rt/portion_")) continue;
      EXPECT_TRUE(topics.insert(publication.topic).second) << publication.topic;
    }
    return topics.size() == kWriters;
  }));
}

TEST(Wire, ALateJoinerLearnsTheTransitionsBefore) {
  const auto robot = join("io");
  Writer<msg::Transition> writer(*robot, robot_topic("io", "transition"));
  for (std::uint64_t number = 1; number <= 70; ++number) {
    msg::Transition transition;
    transition.robot = "io";
    transition.number = number;
    ASSERT_TRUE(writer.write(transition));
  }
  const auto monitor = join("monitor");
  Reader reader(*monitor, robot_topic("io", "transition"), msg::Transition::kRosType);
  std::vector<std::uint64_t> numbers;
  ASSERT_TRUE(wait_until([&] {
    reader.take([&](const Received& received) {
      msg::Transition transition;
      EXPECT_TRUE(msg::decode_cdr(received.cdr, transition));
      numbers.push_back(transition.number);
    });
    return numbers.size() >= 64;
  }));
  EXPECT_EQ(numbers.front(), 7u);
  EXPECT_EQ(numbers.back(), 70u);
}

TEST(Wire, SaysWhenAMessageWasSent) {
  const auto robot = join();
  Writer<msg::RobotState> writer(*robot, "rt/clocked/state");
  Reader reader(*robot, "rt/clocked/state", kStateType);
  const auto before = wall_clock_ns();
  ASSERT_TRUE(writer.write(state_of("io", 1)));
  std::int64_t sent_ns = 0;
  ASSERT_TRUE(wait_until([&] {
    reader.take([&](const Received& received) { sent_ns = received.sent_ns; });
    return sent_ns != 0;
  }));
  EXPECT_GE(sent_ns, before);
  EXPECT_LE(sent_ns, wall_clock_ns());
}

TEST(Wire, TellsWhichProcessSentAMessageByWhatThatAnnounced) {
  const auto robot = join("io");
  Reader reader(*robot, "rt/signed/state", kStateType);
  for (const std::string name : {"monitor", "swap"}) {
    const auto other = join(name);
    Writer<msg::RobotState> writer(*other, "rt/signed/state");
    ASSERT_TRUE(wait_until([&] { return writer.readers() == 1; }));
    ASSERT_TRUE(writer.write(state_of("someone_else", 1)));
    std::optional<Sender> sender;
    ASSERT_TRUE(wait_until([&] {
      reader.take([&](const Received& received) { sender = reader.sender(received.writer); });
      return sender.has_value();
    }));
    EXPECT_EQ(sender->name, name);
    EXPECT_EQ(sender->address, "");  // it is in this process
  }
}

TEST(Wire, ASenderThatHasLeftIsNobody) {
  const auto robot = join("io");
  Reader reader(*robot, "rt/left/state", kStateType);
  {
    const auto other = join("monitor");
    Writer<msg::RobotState> writer(*other, "rt/left/state");
    ASSERT_TRUE(wait_until([&] { return writer.readers() == 1; }));
    ASSERT_TRUE(writer.write(state_of("io", 1)));
  }
  ASSERT_TRUE(wait_until([&] { return reader.writers() == 0; }));
  bool taken = false;
  ASSERT_TRUE(wait_until([&] {
    reader.take([&](const Received& received) {
      taken = true;
      EXPECT_EQ(reader.sender(received.writer), std::nullopt);
    });
    return taken;
  }));
}

TEST(Wire, ReadersAreCountedSoThatImagesAreMadeForSomebodyOnly) {
  const auto robot = join();
  Writer<msg::CompressedImage> writer(*robot, "rt/io/camera/compressed");
  EXPECT_EQ(writer.readers(), 0);
  {
    Reader reader(*robot, "rt/io/camera/compressed", msg::CompressedImage::kRosType);
    EXPECT_TRUE(wait_until([&] { return writer.readers() == 1; }));
  }
  EXPECT_TRUE(wait_until([&] { return writer.readers() == 0; }));
}

TEST(Wire, DiscoveryListsTopicsWithTheirTypesAndForgetsThem) {
  const auto robot = join("io");
  const auto monitor = join("monitor");
  Discovery discovery(*monitor);
  const auto listed = [&] {
    const auto all = discovery.publications();
    return std::find_if(all.begin(), all.end(), [](const Publication& publication) {
             return publication.topic == "rt/discovered/state" &&
                    publication.dds_type == find_schema_by_ros_type(kStateType)->dds_type;
           }) != all.end();
  };
  {
    Writer<msg::RobotState> writer(*robot, "rt/discovered/state");
    EXPECT_TRUE(wait_until(listed));
  }
  EXPECT_TRUE(wait_until([&] { return !listed(); }));
}

TEST(Wire, ATypeThatIsNoneIsRefusedByName) {
  const auto robot = join();
  try {
    Reader reader(*robot, "rt/x", "galilean_msgs/msg/Nothing");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("galilean_msgs/msg/Nothing"), std::string::npos);
  }
}

TEST(Wire, DomainsThatAreNoneAreRefusedInASentence) {
  EXPECT_FALSE(Participant::join("x", 233).ok());
  // The last one would be domain 1 in 32 bits.
  for (const char* given : {"seven", "233", "-1", "4294967297"}) {
    setenv("ROS_DOMAIN_ID", given, 1);
    const auto joined = Participant::join("x");
    unsetenv("ROS_DOMAIN_ID");
    ASSERT_FALSE(joined.ok()) << given;
    EXPECT_NE(joined.error().message.find(given), std::string::npos) << joined.error().message;
  }
}

TEST(Wire, TellsTheDomainThatWasJoinedHoweverItWasChosen) {
  EXPECT_EQ(join()->domain(), static_cast<std::uint32_t>(kDomain));
  setenv("ROS_DOMAIN_ID", std::to_string(kDomain).c_str(), 1);
  const auto joined = Participant::join("test");
  unsetenv("ROS_DOMAIN_ID");
  ASSERT_TRUE(joined.ok());
  EXPECT_EQ(joined.value()->domain(), static_cast<std::uint32_t>(kDomain));
}

TEST(Schemas, AreFoundByBothNames) {
  for (const auto& schema : schemas()) {
    EXPECT_EQ(find_schema_by_ros_type(schema.ros_type), &schema);
    EXPECT_EQ(find_schema_by_dds_type(schema.dds_type), &schema);
  }
  EXPECT_EQ(find_schema_by_dds_type("std_msgs::msg::dds_::String_"), nullptr);
}

TEST(Wire, TheGraphTellsWhoWritesAndWhoReadsUntilTheyLeave) {
  const auto robot = join("io"), watcher = join("watcher");
  const auto topic = robot_topic("io", "state");
  Writer<msg::RobotState> writer(*robot, topic);
  Graph graph(*watcher);
  {
    const auto monitor = join("monitor");
    const Reader reader(*monitor, topic, kStateType);
    EXPECT_TRUE(wait_until([&] {
      return graph.topics()[topic] == Graph::Ends{{"io"}, {"monitor"}};
    }));
  }
  EXPECT_TRUE(wait_until([&] { return graph.topics()[topic].readers.empty(); }));
}

}  // namespace
}  // namespace galilean::wire
