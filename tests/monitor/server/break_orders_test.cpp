// SPDX-License-Identifier: BSD-3-Clause
// Break points over HTTP and as a Foxglove service: what reaches the robots, what is refused, and
// what robots tell.
#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "tests/monitor/scripted_robot.h"
#include "tests/monitor/server/foxglove/foxglove_socket.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

namespace http = boost::beast::http;
using nlohmann::json;
using testing::HasSubstr;
namespace kinds = msg::BreakPoint_Constants;

class BreakOrdersTest : public ServerFixture {
 protected:
  static constexpr const char* kNobody = "nobody";

  void SetUp() override {
    ServerFixture::SetUp();
    io = std::make_unique<ScriptedRobot>("io", test_domain(), catalog);
    wait_for_robots(1);
    // What is sent before DDS has matched writer and reader is lost.
    ASSERT_TRUE(becomes_true([&] {
      (void)post("/api/breaks", {{"order", "clear"}, {"author", kNobody}});
      (void)post("/api/command", {{"kind", "resume"}, {"author", kNobody}});
      return takes_any(orders) && takes_any(commands);
    }));
  }
  void TearDown() override {
    io.reset();
    ServerFixture::TearDown();
  }

  HttpAnswer order(const json& body) { return post("/api/breaks", body); }
  std::string objection(const json& body) {
    const auto answer = order(body);
    EXPECT_EQ(answer.status, 400U) << body;
    return answer.as_json()["detail"];
  }
  static bool takes_any(wire::Reader& reader) {
    bool any = false;
    reader.take([&](const wire::Received&) { any = true; });
    return any;
  }
  /// Returns what came since the last call, once there is one at least.
  template <class M = msg::BreakOrder>
  std::vector<M> heard(wire::Reader& reader) {
    std::vector<M> all;
    EXPECT_TRUE(becomes_true([&] {
      reader.take([&](const wire::Received& received) {
        M message;
        EXPECT_TRUE(msg::decode_cdr(received.cdr, message));
        if (message.author != kNobody) all.push_back(std::move(message));
      });
      return !all.empty();
    }));
    return all;
  }
  json robot() { return get("/api/team").as_json()["robots"][0]; }

  const std::unique_ptr<wire::Participant> participant =
      wire::Participant::join("listener", test_domain()).value();
  wire::Reader orders{*participant, wire::kBreakOrderTopic, msg::BreakOrder::kRosType};
  wire::Reader commands{*participant, wire::kCommandTopic, msg::Command::kRosType};
  wire::Writer<msg::Breaks> breaks{*participant, wire::robot_topic("io", "breaks")};
  std::unique_ptr<ScriptedRobot> io;
};

json points(std::size_t count) {
  auto all = json::array();
  for (std::size_t i = 0; i < count; ++i) all.push_back({{"to", "state_" + std::to_string(i)}});
  return all;
}

TEST_F(BreakOrdersTest, AnOrderReachesTheRobotsAsItWasGiven) {
  const auto answer = order(
      {{"order", "set"},
       {"targets", {"io"}},
       {"author", "Ada"},
       {"points", {{{"from", "wander"}, {"to", "grab"}, {"kind", "lock"}}, {{"to", "rest"}}}}});
  ASSERT_EQ(answer.status, 200U) << answer.body;
  const auto sent = heard(orders).at(0);
  EXPECT_EQ(sent.id, answer.as_json()["id"]);
  EXPECT_EQ(sent.author, "Ada");
  EXPECT_EQ(sent.order, "set");
  EXPECT_EQ(sent.targets, std::vector<std::string>{"io"});
  EXPECT_EQ(sent.points, (std::vector<msg::BreakPoint>{{"wander", "grab", kinds::LOCK},
                                                       {"", "rest", kinds::STOP}}));
  EXPECT_GT(sent.stamp.sec, 0);
}

TEST_F(BreakOrdersTest, EveryOrderAndAsManyPointsAsARobotHasAreTaken) {
  for (const char* name : {"set", "remove", "let_through"})
    EXPECT_EQ(order({{"order", name}, {"points", points(32)}}).status, 200U) << name;
  EXPECT_EQ(order({{"order", "clear"}}).status, 200U);
  std::vector<std::string> names;
  while (names.size() < 4)
    for (const auto& each : heard(orders)) {
      names.push_back(each.order);
      EXPECT_EQ(each.points.size(), each.order == "clear" ? 0U : 32U);
      EXPECT_TRUE(each.targets.empty()) << "that is the team";
    }
  EXPECT_THAT(names, testing::ElementsAre("set", "remove", "let_through", "clear"));
}

TEST_F(BreakOrdersTest, ABadOrderIsToldWhatIsWrong) {
  const json point{{"to", "grab"}};
  const auto set = [](const json& one) {
    return json{{"order", "set"}, {"points", json::array({one})}};
  };
  EXPECT_EQ(objection({{"points", {point}}}), "'order' must be set, remove, clear or let_through.");
  EXPECT_EQ(objection({{"order", "stop"}, {"points", {point}}}),
            "'order' must be set, remove, clear or let_through.");
  for (const char* name : {"set", "remove", "let_through"})
    EXPECT_EQ(objection({{"order", name}, {"points", json::array()}}),
              "'points' must name one break point or more.");
  EXPECT_THAT(objection({{"order", "set"}}), HasSubstr("'points'"));
  EXPECT_EQ(objection({{"order", "clear"}, {"points", {point}}}),
            "'points' must be left out: clear takes all break points off.");
  EXPECT_EQ(objection({{"order", "set"}, {"points", points(33)}}),
            "'points' must name 32 at most: a robot has no more.");
  EXPECT_EQ(objection(set(json::object())),
            "One of 'points' is wrong: 'from' or 'to' must name a state.");
  EXPECT_EQ(objection(set({{"to", "grab"}, {"kind", "pause"}})),
            "One of 'points' is wrong: 'kind' must be stop, stop_team or lock.");
  EXPECT_EQ(objection(set({{"to", 3}})), "One of 'points' is wrong: 'to' must be a string.");
  EXPECT_EQ(objection(set("grab")), "Each of 'points' must be an object with 'from' or 'to'.");
  EXPECT_EQ(order({{"order", "clear"}, {"targets", {"europa"}}}).status, 404U);
}

TEST_F(BreakOrdersTest, WhoMayNotSteerMayNotSetBreakPoints) {
  const std::string clear = R"({"order":"clear"})";
  EXPECT_EQ(request(http::verb::post, "/api/breaks", clear).status, 403U);
  EXPECT_EQ(request(http::verb::post, "/api/breaks", clear, bearer("viewer.token")).status, 403U);
  ASSERT_EQ(order({{"order", "remove"}, {"points", points(1)}}).status, 200U);
  EXPECT_EQ(heard(orders).at(0).order, "remove") << "no other came before it";
}

TEST_F(BreakOrdersTest, TheServiceDoesTheSame) {
  const auto header = bearer("operator.token").at("Authorization");
  FoxgloveSocket socket(host(), monitor->port(), {},
                        "/ws?token=" + header.substr(header.find(' ') + 1));
  std::uint32_t service = 0;
  for (const auto& each : socket.services())
    if (each["name"] == "/galilean/breaks") service = each["id"];
  socket.send_binary(service_call(
      service, 7, R"({"order": "set", "points": [{"from": "grab", "kind": "stop_team"}]})"));
  EXPECT_EQ(heard(orders).at(0).points,
            (std::vector<msg::BreakPoint>{{"grab", "", kinds::STOP_TEAM}}));
  socket.send_binary(service_call(service, 8, R"({"order": "set"})"));
  EXPECT_THAT(socket.read_op("serviceCallFailure")["message"].get<std::string>(),
              HasSubstr("'points'"));
}

TEST_F(BreakOrdersTest, AStepIsACommand) {
  EXPECT_EQ(post("/api/command", {{"kind", "step"}, {"targets", {"io"}}}).status, 200U);
  EXPECT_EQ(heard<msg::Command>(commands).at(0).kind, msg::Command_Constants::STEP);
}

TEST_F(BreakOrdersTest, WhatARobotTellsStandsInTheTeam) {
  EXPECT_EQ(robot()["breaks"], nullptr);
  EXPECT_EQ(robot()["break_reason"], "");
  msg::Breaks told;
  told.robot = "io";
  told.points = {{"wander", "grab", kinds::STOP}};
  told.stopped = true;
  told.stopped_at = 7;
  told.stopped_by = msg::Breaks_Constants::BREAK_POINT;
  told.break_robot = "io";
  told.break_point = {"wander", "grab", kinds::STOP};
  told.author = "Anna";
  told.waits_at_from = "grab";
  told.waits_at_to = "move";
  told.stamp = wire::ros_time(5'000'000'000);
  told.waits_since = wire::ros_time(2'000'000'000);
  told.answers = {{"x", ""}, {"y", "there is no lock"}};
  ASSERT_TRUE(breaks.write(told));
  ASSERT_TRUE(becomes_true([&] { return !robot()["breaks"].is_null(); }));
  const auto shown = robot();
  EXPECT_EQ(shown["break_reason"], "stopped at wander -> grab (Anna's break point)");
  EXPECT_EQ(shown["breaks"]["points"],
            json::array({{{"from", "wander"}, {"to", "grab"}, {"kind", "stop"}}}));
  EXPECT_EQ(shown["breaks"]["stopped_at"], 7);
  EXPECT_EQ(shown["breaks"]["stopped_by"], "break_point");
  EXPECT_EQ(shown["breaks"]["break_robot"], "io");
  EXPECT_EQ(shown["breaks"]["break_point"], shown["breaks"]["points"][0]);
  EXPECT_EQ(shown["breaks"]["waits_at_to"], "move");
  EXPECT_GE(shown["breaks"]["waits_s"], 3.0);
  EXPECT_LT(shown["breaks"]["waits_s"], 30.0);
  EXPECT_EQ(shown["breaks"]["answers"],
            json::array(
                {{{"id", "x"}, {"refused", ""}}, {{"id", "y"}, {"refused", "there is no lock"}}}));
  EXPECT_EQ(get("/api/status").as_json()["robots"][0]["break_reason"], shown["break_reason"]);
}

}  // namespace
}  // namespace galilean::monitor
