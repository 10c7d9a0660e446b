// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/foxglove/foxglove_hub.h"

#include <gmock/gmock.h>

#include "monitor/server/websocket/outbox.h"

namespace galilean::monitor::foxglove {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class FakeLink final : public Link {
 public:
  void flush() override { ++flushes; }
  void close(const std::string& reason) override { closed_for = reason; }
  int flushes = 0;
  std::string closed_for;
};

Channel channel(std::uint32_t id, const std::string& topic, const char* ros_type) {
  return {id, topic, wire::find_schema_by_ros_type(ros_type), wire::delivery_of(ros_type)};
}

class HubTest : public testing::Test {
 protected:
  void SetUp() override {
    hub.add_channel(state);
    hub.add_channel(transition);
    hub.add_channel(camera);
    client = hub.connect(link, true);
  }
  [[nodiscard]] std::vector<Frame> sent() { return client->outbox().take(100'000); }
  [[nodiscard]] static std::string text(const Frame& frame) {
    return {frame.payload->begin(), frame.payload->end()};
  }
  void send(const Channel& to, std::uint8_t content) {
    hub.send({to, 5, 4, std::make_shared<const std::vector<std::uint8_t>>(8, content)});
  }
  void subscribe(std::uint32_t id, std::uint32_t channel_id) {
    client->receive_text(
        json{{"op", "subscribe"}, {"subscriptions", {{{"id", id}, {"channelId", channel_id}}}}}
            .dump());
  }

  const Channel state = channel(1, "rt/io/state", "galilean_msgs/msg/RobotState");
  const Channel transition = channel(2, "rt/io/transition", "galilean_msgs/msg/Transition");
  const Channel camera = channel(3, "rt/io/camera/compressed", "sensor_msgs/msg/CompressedImage");
  std::vector<std::pair<std::uint32_t, bool>> demands;
  Hub hub{"monitor", [this](std::uint32_t id, bool wanted) { demands.emplace_back(id, wanted); }};
  FakeLink link;
  std::unique_ptr<Hub::Client> client;
};

TEST_F(HubTest, GreetsWithServerInfoAndChannels) {
  const auto frames = sent();
  ASSERT_EQ(frames.size(), 2U);
  const auto info = json::parse(text(frames[0]));
  EXPECT_EQ(info["op"], "serverInfo");
  EXPECT_EQ(info["supportedEncodings"], json::array({"json"}));
  EXPECT_EQ(
      info["capabilities"],
      (json::array({"services", "time", "parameters", "parametersSubscribe", "connectionGraph"})));
  const auto channels = json::parse(text(frames[1]))["channels"];
  ASSERT_EQ(channels.size(), 3U);
  EXPECT_EQ(channels[0]["topic"], "/io/state");
  EXPECT_EQ(channels[0]["encoding"], "cdr");
  EXPECT_EQ(channels[0]["schemaEncoding"], "ros2idl");
  EXPECT_THAT(channels[0]["schema"].get<std::string>(), HasSubstr("struct RobotState"));
}

TEST_F(HubTest, OneClientGetsAMessageNotTooOften) {
  ServerLimits limits;
  limits.subscriptions_of_channel = 2;
  hub.limit(limits);
  for (std::uint32_t id = 1; id <= 3; ++id) subscribe(id, 2);
  EXPECT_EQ(hub.counts().subscriptions, 2U);
  EXPECT_THAT(text(sent().back()), HasSubstr("at most 2 subscriptions to one channel"));
  subscribe(4, 1);
  EXPECT_EQ(hub.counts().subscriptions, 3U) << "another channel is another matter";
  client->receive_text(R"({"op":"unsubscribe","subscriptionIds":[1]})");
  subscribe(5, 2);
  EXPECT_EQ(hub.counts().subscriptions, 3U);
}

TEST_F(HubTest, WhereTooMuchWaitsForAllTheSlowestClientGoes) {
  FakeLink quick_link;
  const auto quick = hub.connect(quick_link, true);
  ServerLimits limits;
  limits.waiting_events_bytes = 20'000;
  hub.limit(limits);
  (void)sent();
  (void)quick->outbox().take(100);
  subscribe(1, 2);
  quick->receive_text(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":2}]})");
  for (int i = 0; i < 1000; ++i) {
    send(transition, 1);
    if (i % 100 == 0) (void)quick->outbox().take(100'000);
  }
  EXPECT_THAT(link.closed_for, HasSubstr("too slow"));
  EXPECT_EQ(quick_link.closed_for, "");
  EXPECT_EQ(hub.counts().dismissed, 1U);
  EXPECT_EQ(hub.limit_counts()->count(Limit::kWaitingEventsOfAll), 1U);
}

TEST_F(HubTest, AMessageCarriesTheClientsSubscriptionAndSharesItsBytes) {
  (void)sent();
  subscribe(0, 2);
  const auto bytes = std::make_shared<const std::vector<std::uint8_t>>(300, std::uint8_t{9});
  hub.send({transition, 0x0102030405060708, 0, bytes});
  const auto frames = sent();
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].payload, bytes);
  const std::vector<std::uint8_t> head(frames[0].head_bytes().begin(),
                                       frames[0].head_bytes().end());
  EXPECT_EQ(head,
            (std::vector<std::uint8_t>{0x82, 126, 1, 57, 1, 0, 0, 0, 0, 8, 7, 6, 5, 4, 3, 2, 1}));
}

TEST_F(HubTest, ALateSubscriberIsToldWhatIsAndWhatHappened) {
  send(state, 1);
  send(state, 2);
  for (std::uint8_t number = 0; number < 70; ++number) send(transition, number);
  (void)sent();
  subscribe(7, 1);
  EXPECT_EQ(sent().size(), 1U);
  subscribe(8, 2);
  const auto events = sent();
  ASSERT_EQ(events.size(), 64U);
  EXPECT_EQ(events.back().payload->front(), 69);
}

TEST_F(HubTest, ASlowClientGetsEveryEventButOnlyTheNewestState) {
  subscribe(1, 1);
  subscribe(2, 2);
  (void)sent();
  for (std::uint8_t number = 0; number < 200; ++number) {
    send(state, number);
    send(transition, number);
  }
  const auto frames = sent();
  EXPECT_EQ(frames.size(), 201U);
  EXPECT_EQ(frames.back().payload->front(), 199);
  EXPECT_EQ(hub.counts().superseded, 199U);
}

TEST_F(HubTest, ASlowClientGetsTheNewestTenOfAFlow) {
  const Channel frames_of_all = channel(4, "rt/tf", "tf2_msgs/msg/TFMessage");
  hub.add_channel(frames_of_all);
  subscribe(4, 4);
  (void)sent();
  for (std::uint8_t number = 0; number < 200; ++number) send(frames_of_all, number);
  const auto frames = sent();
  ASSERT_EQ(frames.size(), 10U);
  EXPECT_EQ(frames.front().payload->front(), 190);
  EXPECT_EQ(frames.back().payload->front(), 199);
  EXPECT_EQ(hub.counts().superseded, 190U);
}

TEST_F(HubTest, AClientThatNeverReadsItsEventsIsClosedWithTheReason) {
  subscribe(2, 2);
  const auto large = std::make_shared<const std::vector<std::uint8_t>>(1 << 20);
  for (int i = 0; i < 20; ++i) hub.send({transition, 0, 0, large});
  EXPECT_THAT(link.closed_for, HasSubstr("too slow"));
  EXPECT_TRUE(client->outbox().empty());
  EXPECT_EQ(hub.counts().dismissed, 1U);
}

TEST_F(HubTest, PicturesAreWantedOnlyWhileSomebodyLooks) {
  FakeLink other_link;
  auto other = hub.connect(other_link, false);
  subscribe(1, 3);
  other->receive_text(R"({"op":"subscribe","subscriptions":[{"id":9,"channelId":3}]})");
  client->receive_text(R"({"op":"unsubscribe","subscriptionIds":[1]})");
  EXPECT_EQ(demands, (std::vector<std::pair<std::uint32_t, bool>>{{3, true}}));
  other.reset();
  EXPECT_EQ(demands.back(), (std::pair<std::uint32_t, bool>{3, false}));
}

TEST_F(HubTest, NonsenseIsAnsweredNotObeyed) {
  (void)sent();
  const std::vector<std::string> nonsense{
      "",
      "[",
      "3",
      "{}",
      R"({"op":3})",
      R"({"op":"fly"})",
      R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})",
      R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":99}]})",
      R"({"op":"subscribe","subscriptions":[1]})",
      R"({"op":"unsubscribe","subscriptionIds":["x"]})",
      std::string(100'000, '['),
      "{\"op\":\"\xff\xfe\"}"};
  for (const auto& each : nonsense) {
    client->receive_text(each);
    const auto frames = sent();
    ASSERT_EQ(frames.size(), 1U) << each.substr(0, 80);
    EXPECT_EQ(json::parse(text(frames[0]))["op"], "status");
  }
  client->receive_text(R"({"op":"subscribe"})");
  const std::vector<std::uint8_t> truncated{2, 1, 0, 0, 0, 1, 0, 0, 0, 255, 255, 255, 255};
  for (std::size_t size = 0; size <= truncated.size(); ++size)
    client->receive_binary(std::span(truncated).first(size));
  EXPECT_EQ(hub.counts().subscriptions, 0U);
}

/// Returns the operation `op` on a list of `items`, each made of the numbers from 0 to `count` - 1.
std::string request_for(const char* op, const char* list, std::uint32_t count,
                        bool is_subscribing) {
  auto items = json::array();
  for (std::uint32_t id = 0; id < count; ++id)
    items.push_back(is_subscribing ? json{{"id", id}, {"channelId", 1}} : json(id));
  return json{{"op", op}, {list, std::move(items)}}.dump();
}

TEST_F(HubTest, VeryManySubscriptionsGoInOneRequestAndTheFaultsAreToldInOneSentence) {
  ServerLimits limits;
  limits.subscriptions = limits.subscriptions_of_channel = 100'000;
  limits.message = {};
  hub.limit(limits);
  (void)sent();
  client->receive_text(request_for("subscribe", "subscriptions", 100'000, true));
  EXPECT_EQ(hub.counts().subscriptions, 100'000U);
  send(state, 1);
  // This is linear: were each id looked for among all others, it would take half a minute.
  const auto all = request_for("unsubscribe", "subscriptionIds", 100'000, false);
  client->receive_text(all);
  EXPECT_EQ(hub.counts().subscriptions, 0U);
  EXPECT_TRUE(sent().empty()) << "what waited for a subscription that is over is dropped";
  client->receive_text(all);
  const auto frames = sent();
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(json::parse(text(frames[0]))["message"],
            "There is no subscription 0. The same request has 99999 more such faults.");
}

TEST_F(HubTest, WhatAClientMayAskForIsBounded) {
  ServerLimits limits;
  limits.subscriptions = 10;
  limits.subscriptions_of_channel = 100;
  limits.message = {.bytes = 2000, .values = 100};
  hub.limit(limits);
  (void)sent();
  client->receive_text(request_for("subscribe", "subscriptions", 12, true));
  EXPECT_EQ(hub.counts().subscriptions, 10U);
  auto frames = sent();
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_THAT(text(frames[0]), HasSubstr("at most 10 subscriptions. The same request has 1 more"));
  EXPECT_EQ(hub.limit_counts()->count(Limit::kSubscriptions), 2U);
  client->receive_text(request_for("unsubscribe", "subscriptionIds", 200, false));
  EXPECT_EQ(hub.counts().subscriptions, 10U) << "a request with too many values does nothing";
  client->receive_text(std::string(2001, ' '));
  frames = sent();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_THAT(text(frames[0]), HasSubstr("more than 100 values"));
  EXPECT_THAT(text(frames[1]), HasSubstr("more than 2000 bytes"));
  EXPECT_EQ(hub.limit_counts()->count(Limit::kMessage), 1U);
}

TEST_F(HubTest, CallsThatWaitForAnAnswerAreBounded) {
  ServerLimits limits;
  limits.waiting_calls = 2;
  Hub busy("monitor", [](std::uint32_t, bool) {});
  busy.limit(limits);
  std::vector<Hub::Answer> waiting;
  busy.add_service({"/wait", "t/T", json::object(), json::object()},
                   [&](const json&, const Hub::Answer& answer) { waiting.push_back(answer); });
  FakeLink its_link;
  const auto caller = busy.connect(its_link, true);
  const std::vector<std::uint8_t> call{2, 1, 0, 0, 0,   7,   0,   0,   0,
                                       4, 0, 0, 0, 'j', 's', 'o', 'n', '3'};
  for (int i = 0; i < 3; ++i) caller->receive_binary(call);
  EXPECT_EQ(waiting.size(), 2U);
  EXPECT_EQ(busy.limit_counts()->count(Limit::kCalls), 1U);
  waiting.front()(json(1));
  waiting.erase(waiting.begin());
  caller->receive_binary(call);
  EXPECT_EQ(waiting.size(), 2U) << "an answer makes room for the next call";
}

TEST_F(HubTest, AServiceIsCalledByItsIdAndAnswersItsCall) {
  hub.add_service({"/echo", "test/Echo", json::object(), json::object()},
                  [](const json& request, const Hub::Answer& answer) {
                    if (request.contains("fail")) return answer(Error{"no"});
                    answer(json{{"got", request}});
                  });
  (void)sent();
  const auto call = [&](const std::string& request) {
    std::vector<std::uint8_t> bytes{2, 1, 0, 0, 0, 77, 0, 0, 0, 4, 0, 0, 0, 'j', 's', 'o', 'n'};
    bytes.insert(bytes.end(), request.begin(), request.end());
    client->receive_binary(bytes);
    return sent().at(0);
  };
  const auto answer = call(R"({"a":1})");
  EXPECT_EQ(answer.head[2], 3) << "opcode of a service's answer";
  EXPECT_EQ(answer.head[7], 77) << "the call's id";
  EXPECT_EQ(text(answer), R"(json{"got":{"a":1}})");
  const auto failure = json::parse(text(call(R"({"fail":1})")));
  EXPECT_EQ(failure["op"], "serviceCallFailure");
  EXPECT_EQ(failure["callId"], 77);
  EXPECT_EQ(failure["message"], "no");
}

TEST_F(HubTest, ParametersAreReadSetByOperatorsAndToldWhenTheyChange) {
  std::vector<std::pair<std::string, json>> set;
  hub.on_set_parameter([&](const Parameter& wanted, const Hub::Answer& answer) {
    set.emplace_back(wanted.name, wanted.value);
    if (!wanted.value.is_boolean()) answer(Error{"true or false"});
  });
  hub.send_parameters({{"/io.held", false}, {"/io.program_name", "a.bhdl"}});
  (void)sent();
  const auto ask = [&](const char* request) {
    client->receive_text(request);
    std::vector<json> answers;
    for (const auto& frame : sent()) answers.push_back(json::parse(text(frame)));
    return answers;
  };
  const auto all = ask(R"({"op":"getParameters","parameterNames":[],"id":"a"})").at(0);
  EXPECT_EQ(all["id"], "a");
  ASSERT_EQ(all["parameters"].size(), 2U);
  EXPECT_EQ(all["parameters"][0], (json{{"name", "/io.held"}, {"value", false}}));
  EXPECT_TRUE(ask(R"({"op":"subscribeParameterUpdates","parameterNames":["/io.held"]})").empty());

  EXPECT_TRUE(
      ask(R"({"op":"setParameters","parameters":[{"name":"/io.held","value":true}]})").empty());
  EXPECT_EQ(set.at(0), (std::pair<std::string, json>{"/io.held", true}));
  EXPECT_EQ(ask(R"({"op":"setParameters","parameters":[{"name":"/io.held","value":3}]})")
                .at(0)["message"],
            "true or false");
  EXPECT_EQ(ask(R"({"op":"setParameters","parameters":[{"name":"/x","value":3}]})").at(0)["op"],
            "status");
  EXPECT_EQ(set.size(), 2U);

  hub.send_parameters({{"/io.held", true}, {"/io.program_name", "b.bhdl"}});
  const auto updates = sent();
  ASSERT_EQ(updates.size(), 1U);
  EXPECT_EQ(json::parse(text(updates[0]))["parameters"],
            json::array({{{"name", "/io.held"}, {"value", true}}}));

  FakeLink other_link;
  const auto viewer = hub.connect(other_link, false);
  viewer->receive_text(
      R"({"op":"setParameters","parameters":[{"name":"/io.held","value":false}]})");
  EXPECT_EQ(set.size(), 2U) << "a viewer sets nothing";
}

TEST_F(HubTest, TheConnectionGraphIsToldWholeThenByItsChanges) {
  hub.send_graph({{{"/io/state", {"io"}}, {"/tf", {"io", "monitor"}}}, {{"/io/state", {"top"}}}});
  EXPECT_FALSE(hub.graph_is_watched());
  (void)sent();
  client->receive_text(R"({"op":"subscribeConnectionGraph"})");
  EXPECT_TRUE(hub.graph_is_watched());
  const auto whole = json::parse(text(sent().at(0)));
  EXPECT_EQ(whole["op"], "connectionGraphUpdate");
  EXPECT_EQ(whole["publishedTopics"][1],
            (json{{"name", "/tf"}, {"publisherIds", {"io", "monitor"}}}));
  EXPECT_EQ(whole["subscribedTopics"].size(), 1U);

  hub.send_graph({{{"/tf", {"monitor"}}}, {{"/io/state", {"top"}}}});
  const auto change = json::parse(text(sent().at(0)));
  EXPECT_EQ(change["publishedTopics"],
            json::array({{{"name", "/tf"}, {"publisherIds", {"monitor"}}},
                         {{"name", "/io/state"}, {"publisherIds", json::array()}}}));
  EXPECT_EQ(change["removedTopics"], json::array()) << "somebody still waits for it";
  hub.send_graph({{{"/tf", {"monitor"}}}, {}});
  EXPECT_EQ(json::parse(text(sent().at(0)))["removedTopics"], json::array({"/io/state"}));
  client->receive_text(R"({"op":"unsubscribeConnectionGraph"})");
  hub.send_graph({});
  EXPECT_TRUE(sent().empty());
}

}  // namespace
}  // namespace galilean::monitor::foxglove
