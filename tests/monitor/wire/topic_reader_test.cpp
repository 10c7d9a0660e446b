// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/topic_reader.h"

#include <gtest/gtest.h>

#include <set>

#include "core/json_text.h"
#include "core/wire/messages.h"
#include "core/wire/writer.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"
#include "tests/monitor/wire/foreign_messages.h"

namespace galilean::monitor {
namespace {

using wire::Cdr;
using wire::Foreign;
using wire::ForeignTalk;
using wire::wait_until;

const int kDomain = free_domain();
constexpr const char* kTopic = "rt/io/state";

/// A process that reads a topic, beside another that writes it.
class Scene {
 public:
  ForeignTalk talk(Foreign message, Cdr version = Cdr::kSecond) {
    return {foreign_.participant(), message, kTopic, version};
  }

  /// Reads the topic once so many of its writers are known.
  TopicReader& read(std::size_t writers) {
    FoundTopic topic{.dds_topic = kTopic};
    EXPECT_TRUE(wait_until([&] {
      topic.ends.clear();
      for (const auto& end : endpoints_.known())
        if (end.writes && end.topic == kTopic && end.process != "reader") topic.ends.push_back(end);
      return topic.ends.size() == writers;
    }));
    reader_ = std::make_unique<TopicReader>(
        TopicReader::Wire{*participant_, endpoints_, definitions_}, topic, [] {});
    return *reader_;
  }

  /// Returns so many of the messages that come, or why they cannot be decoded.
  std::multiset<std::string> await(std::size_t count) {
    std::multiset<std::string> messages;
    EXPECT_TRUE(wait_until([&] {
      reader_->take([&](const wire::Received& received) {
        const auto message = reader_->decode(received);
        messages.insert(message ? ordered_json_text(message.value()) : message.error().message);
      });
      return messages.size() >= count;
    }));
    return messages;
  }

 private:
  std::unique_ptr<wire::Participant> participant_ =
      wire::Participant::join("reader", kDomain).value();
  wire::ForeignProcess foreign_{"talker", kDomain};
  wire::Endpoints endpoints_{*participant_};
  Definitions definitions_{*participant_, [] { return false; }};
  std::unique_ptr<TopicReader> reader_;
};

TEST(TopicReader, DecodesATypeThatTheProgramWasNotBuiltWith) {
  Scene scene;
  auto talk = scene.talk(Foreign::kReport);
  ASSERT_TRUE(talk.write());
  auto& reader = scene.read(1);
  EXPECT_TRUE(reader.prepare().ok());
  EXPECT_EQ(scene.await(1), std::multiset{foreign_json(Foreign::kReport)});
  EXPECT_TRUE(reader.take_notes().empty());
}

TEST(TopicReader, DecodesTwoTypesOnOneTopicEachByItsOwn) {
  Scene scene;
  auto report = scene.talk(Foreign::kReport), settings = scene.talk(Foreign::kSettings);
  ASSERT_TRUE(report.write() && settings.write());
  scene.read(2);
  EXPECT_EQ(scene.await(2),
            (std::multiset{foreign_json(Foreign::kReport), foreign_json(Foreign::kSettings)}));
}

TEST(TopicReader, ATypeThatIsDefinedOtherwiseIsDecodedByItsOwnDefinitionAndToldOf) {
  Scene scene;
  auto talk = scene.talk(Foreign::kRobotState, Cdr::kFirst);
  ASSERT_TRUE(talk.write());
  auto& reader = scene.read(1);
  EXPECT_EQ(scene.await(1), std::multiset{foreign_json(Foreign::kRobotState)});
  EXPECT_EQ(reader.take_notes(),
            std::vector<std::string>{"talker's definition of galilean_msgs/msg/RobotState differs "
                                     "from ours: its messages are decoded by its own"});
  EXPECT_TRUE(reader.take_notes().empty());
}

TEST(TopicReader, AWriterWithoutTypeInformationIsToldOfWithWhatToDo) {
  Scene scene;
  auto talk = scene.talk(Foreign::kBare, Cdr::kFirst);
  ASSERT_TRUE(talk.write());
  const auto prepared = scene.read(1).prepare();
  ASSERT_FALSE(prepared.ok());
  for (const char* part : {"talker publishes no type information", "bare::Message", "'/io/state'",
                           "use 'ros2 topic echo'", "'galilean rate'"})
    EXPECT_NE(prepared.error().message.find(part), std::string::npos) << prepared.error().message;
  EXPECT_EQ(scene.await(1), std::multiset{prepared.error().message});
}

TEST(TopicReader, DecodesTwoDefinitionsOfOneTypeEachByItsOwn) {
  Scene scene;
  auto talk = scene.talk(Foreign::kRobotState, Cdr::kFirst);
  const auto robot = wire::Participant::join("robot", kDomain).value();
  wire::Writer<msg::RobotState> writer(*robot, kTopic);
  ASSERT_TRUE(talk.write() && writer.write({}));
  scene.read(2);
  const auto messages = scene.await(2);
  EXPECT_EQ(messages.count(foreign_json(Foreign::kRobotState)), 1U);
  EXPECT_NE((*messages.begin() + *messages.rbegin()).find(R"("tick":0,)"), std::string::npos);
}

TEST(TopicReader, GalileansOwnMessagesAreDecodedAsTheyWere) {
  Scene scene;
  const auto robot = wire::Participant::join("robot", kDomain).value();
  wire::Writer<msg::OccupancyGrid> writer(*robot, kTopic);
  msg::OccupancyGrid grid;
  grid.info.width = 2;
  grid.data = {-1, 100};
  ASSERT_TRUE(writer.write(grid));
  scene.read(1);
  const auto text = *scene.await(1).begin();
  EXPECT_NE(text.find(R"("width":2,)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"("data":[-1,100])"), std::string::npos) << text;
}

}  // namespace
}  // namespace galilean::monitor
