// SPDX-License-Identifier: BSD-3-Clause
// Who may steer which robot, over HTTP and as a Foxglove service: what is refused, what never is,
// and what all are told.
#include "core/wire/topic_names.h"
#include "tests/monitor/scripted_robot.h"
#include "tests/monitor/server/foxglove/foxglove_socket.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

namespace http = boost::beast::http;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class LeasesTest : public ServerFixture {
 protected:
  void SetUp() override {
    ServerFixture::SetUp();
    io = std::make_unique<ScriptedRobot>("io", test_domain(), catalog);
    callisto = std::make_unique<ScriptedRobot>("callisto", test_domain(), catalog);
    wait_for_robots(2);
  }
  void TearDown() override {
    io.reset();
    callisto.reset();
    ServerFixture::TearDown();
  }

  HttpAnswer post_as(const std::string& name, const std::string& target, const json& body) {
    auto headers = bearer("operator.token");
    headers["X-Galilean-Operator"] = name;
    headers["X-Galilean-Client"] = name + "s tab";
    return request(http::verb::post, target, body.dump(), headers);
  }
  HttpAnswer resume(const std::string& name, const json& robots) {
    return post_as(name, "/api/command", {{"kind", "resume"}, {"targets", robots}});
  }
  HttpAnswer lease(const std::string& name, const std::string& deed,
                   const std::string& reason = {}) {
    return post_as(name, "/api/lease", {{"do", deed}, {"robots", {"io"}}, {"reason", reason}});
  }
  json io_lease(const std::string& name) {
    auto headers = bearer("operator.token");
    headers["X-Galilean-Operator"] = name;
    const auto status = request(http::verb::get, "/api/status", {}, headers).as_json();
    for (const auto& robot : status["robots"])
      if (robot["name"] == "io") return robot["lease"];
    return "io is not there";
  }

  std::unique_ptr<ScriptedRobot> io, callisto;
};

TEST_F(LeasesTest, WhoSteersFirstHoldsItAndAnotherIsToldWhoDoes) {
  EXPECT_EQ(io_lease("ada"), nullptr);
  ASSERT_EQ(resume("ada", {"io"}).status, 200U);
  const auto hers = io_lease("ada");
  EXPECT_EQ(hers["holder"],
            (json{{"name", "ada"}, {"account", "operator"}, {"client", "adas tab"}}));
  EXPECT_EQ(hers["yours"], true);
  EXPECT_EQ(hers["asker"], nullptr);
  EXPECT_EQ(io_lease("ben")["yours"], false);
  const auto refused = resume("ben", {"io"});
  EXPECT_EQ(refused.status, 409U);
  EXPECT_THAT(refused.as_json()["detail"].get<std::string>(),
              HasSubstr("ada holds io. Ask for it, or take it over with a reason."));
  EXPECT_EQ(refused.as_json()["leases"]["io"]["holder"]["name"], "ada");
  EXPECT_EQ(resume("ben", {"callisto"}).status, 200U);
}

TEST_F(LeasesTest, EveryOrderThatSteersIsRefusedAndNoStopIs) {
  ASSERT_EQ(resume("ada", {"io"}).status, 200U);
  const json points = json::array({{{"to", "grab"}}});
  const json locks = json::array({{{"to", "grab"}}, {{"to", "rest"}, {"kind", "lock"}}});
  const std::vector<std::pair<std::string, json>> steering{
      {"/api/command", {{"kind", "resume"}, {"targets", {"io"}}}},
      {"/api/command", {{"kind", "step"}, {"targets", {"io"}}}},
      {"/api/command", {{"kind", "push_bumper"}, {"targets", {"io"}}}},
      {"/api/command", {{"kind", "commission"}, {"targets", {"io"}}}},
      {"/api/command", {{"kind", "resume"}}},
      {"/api/breaks", {{"order", "clear"}, {"targets", {"io"}}}},
      {"/api/breaks", {{"order", "set"}, {"targets", {"io"}}, {"points", locks}}},
      {"/api/breaks", {{"order", "remove"}, {"targets", {"io"}}, {"points", points}}},
      {"/api/breaks", {{"order", "let_through"}, {"targets", {"io"}}, {"points", points}}},
      {"/api/push", {{"files", files(kProgram)}, {"targets", {"io"}}}},
      {"/api/simulation/orders", {{"order", "push"}, {"subject", "io"}}},
      {"/api/simulation/orders", {{"order", "start_contest"}}}};
  for (const auto& [target, body] : steering)
    EXPECT_EQ(post_as("ben", target, body).status, 409U) << target << body;
  const std::vector<std::pair<std::string, json>> stopping{
      {"/api/command", {{"kind", "hold"}, {"targets", {"io"}}}},
      {"/api/command", {{"kind", "hold"}}},
      {"/api/command", {{"kind", "decommission"}, {"targets", {"io"}}}},
      {"/api/breaks", {{"order", "set"}, {"targets", {"io"}}, {"points", points}}}};
  for (const auto& [target, body] : stopping)
    EXPECT_EQ(post_as("ben", target, body).status, 200U) << target << body;
  EXPECT_EQ(io_lease("ben")["holder"]["name"], "ada");
}

TEST_F(LeasesTest, AnOrderThatIsRefusedIsKeptWithTheReasonAndNotGiven) {
  ASSERT_EQ(resume("ada", {"io"}).status, 200U);
  ASSERT_EQ(
      post_as("ben", "/api/command", {{"kind", "resume"}, {"author", "ben"}, {"targets", {"io"}}})
          .status,
      409U);
  ASSERT_EQ(post_as("ben", "/api/breaks", {{"order", "clear"}, {"author", "ben"}}).status, 409U);
  const auto orders_of_ben = [&] {
    auto orders = json::array();
    for (const auto& each : list_in("/api/orders", "orders"))
      if (each["author"] == "ben") orders.push_back(each);
    return orders;
  };
  ASSERT_TRUE(becomes_true([&] { return orders_of_ben().size() == 2; }));
  const auto kept = orders_of_ben();
  EXPECT_EQ(kept[0]["kind"], "breaks: clear");
  EXPECT_EQ(kept[0]["outcomes"].size(), 2U) << "it was for the team";
  EXPECT_EQ(kept[1]["kind"], "resume");
  ASSERT_EQ(kept[1]["outcomes"].size(), 1U);
  EXPECT_EQ(kept[1]["outcomes"][0]["of"], "io");
  EXPECT_THAT(kept[1]["outcomes"][0]["outcome"].get<std::string>(),
              AllOf(StartsWith("refused: "), HasSubstr("ada holds io.")));
}

TEST_F(LeasesTest, EveryOrderIsKeptWithTheNameOfWhoGaveIt) {
  ASSERT_EQ(resume("ada", {"io"}).status, 200U);
  ASSERT_EQ(post_as("ben", "/api/command", {{"kind", "hold"}, {"author", "operator"}}).status,
            200U);
  const auto kept_kind_of = [&](const std::string& author) {
    for (const auto& each : list_in("/api/orders", "orders"))
      if (each["author"] == author) return each["kind"].get<std::string>();
    return std::string();
  };
  EXPECT_TRUE(becomes_true([&] { return kept_kind_of("ada") == "resume"; }));
  EXPECT_TRUE(becomes_true([&] { return kept_kind_of("ben") == "hold"; }));
}

TEST_F(LeasesTest, ItIsAskedForGivenRefusedAndTakenOver) {
  ASSERT_EQ(resume("ada", {"io"}).status, 200U);
  ASSERT_EQ(lease("ben", "ask").status, 200U);
  EXPECT_EQ(io_lease("ada")["asker"]["name"], "ben");
  EXPECT_GE(io_lease("ada")["answer_within_s"], 5);
  EXPECT_EQ(io_lease("ben")["asked_by_you"], true);
  EXPECT_EQ(lease("ada", "refuse", "I am parking").status, 200U);
  EXPECT_EQ(io_lease("ben")["asker"], nullptr);
  ASSERT_EQ(lease("ben", "ask").status, 200U);
  ASSERT_EQ(lease("ada", "give").status, 200U);
  EXPECT_EQ(io_lease("ben")["yours"], true);
  EXPECT_EQ(lease("ada", "take").status, 409U) << "without a reason";
  ASSERT_EQ(lease("ada", "take", "it stands in the door").status, 200U);
  EXPECT_EQ(io_lease("ada")["yours"], true);
  ASSERT_EQ(post_as("ada", "/api/lease", {{"do", "release"}}).status, 200U);
  EXPECT_EQ(io_lease("ada"), nullptr);
}

TEST_F(LeasesTest, AWrongRequestIsToldWhatIsWrong) {
  EXPECT_EQ(lease("ada", "steal").status, 400U);
  EXPECT_EQ(post_as("ada", "/api/lease", {{"do", "ask"}}).status, 400U);
  EXPECT_EQ(post_as("ada", "/api/lease", {{"do", "ask"}, {"robots", "io"}}).status, 400U);
  EXPECT_EQ(post_as("ada", "/api/lease", {{"do", "ask"}, {"robots", {"europa"}}}).status, 404U);
  EXPECT_EQ(lease("ada", "give").status, 409U);
  EXPECT_EQ(request(http::verb::post, "/api/lease", R"({"do":"release"})").status, 403U);
}

TEST_F(LeasesTest, OneOperatorWithoutANameSteersFromEverywhere) {
  const json order{{"kind", "resume"}, {"targets", {"io"}}};
  ASSERT_EQ(post("/api/command", order).status, 200U);
  auto headers = bearer("operator.token");
  headers["X-Galilean-Client"] = "another tab";
  EXPECT_EQ(request(http::verb::post, "/api/command", order.dump(), headers).status, 200U);
  const auto header = headers.at("Authorization");
  FoxgloveSocket socket(host(), monitor->port(), {},
                        "/ws?token=" + header.substr(header.find(' ') + 1));
  std::uint32_t service = 0;
  for (const auto& each : socket.services())
    if (each["name"] == "/galilean/lease") service = each["id"];
  ASSERT_NE(service, 0U);
  socket.send_binary(service_call(service, 7, R"({"do": "give", "robots": ["io"]})"));
  EXPECT_THAT(socket.read_op("serviceCallFailure")["message"].get<std::string>(),
              HasSubstr("Nobody asks for io."));
}

/// DDS keeps 64 changes for who joins later, as a command in a terminal does.
TEST_F(LeasesTest, WhoJoinsAfterManyChangesHearsWhoHoldsARobotForLong) {
  ASSERT_EQ(resume("ada", {"io"}).status, 200U);
  for (int turn = 0; turn < 40; ++turn) {
    ASSERT_EQ(resume("ben", {"callisto"}).status, 200U);
    ASSERT_EQ(post_as("ben", "/api/lease", {{"do", "release"}}).status, 200U);
    ASSERT_EQ(io_lease("ada")["yours"], true);  // a word of hers
  }
  const auto participant = wire::Participant::join("late", test_domain()).value();
  wire::Reader changes{*participant, wire::kLeaseChangeTopic, msg::LeaseChange::kRosType};
  std::string holder;
  EXPECT_TRUE(becomes_true([&] {
    changes.take([&](const wire::Received& received) {
      msg::LeaseChange change;
      EXPECT_TRUE(msg::decode_cdr(received.cdr, change));
      if (change.robot == "io") holder = change.holder;
    });
    return !holder.empty();
  }));
  EXPECT_EQ(holder, "ada");
}

TEST_F(LeasesTest, EveryChangeIsToldOnTheWire) {
  const auto participant = wire::Participant::join("listener", test_domain()).value();
  wire::Reader changes{*participant, wire::kLeaseChangeTopic, msg::LeaseChange::kRosType};
  ASSERT_EQ(resume("ada", {"io"}).status, 200U);
  ASSERT_EQ(lease("ben", "take", "it stands in the door").status, 200U);
  std::vector<msg::LeaseChange> heard;
  EXPECT_TRUE(becomes_true([&] {
    changes.take([&](const wire::Received& received) {
      msg::LeaseChange change;
      EXPECT_TRUE(msg::decode_cdr(received.cdr, change));
      heard.push_back(std::move(change));
    });
    return heard.size() >= 2;
  }));
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[0].kind, "taken");
  EXPECT_EQ(heard[1].kind, "taken_over");
  EXPECT_EQ(heard[1].robot, "io");
  EXPECT_EQ(heard[1].text, "ben took it over from ada: it stands in the door");
  EXPECT_EQ(heard[1].holder, "ben");
}

}  // namespace
}  // namespace galilean::monitor
