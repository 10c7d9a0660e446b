// SPDX-License-Identifier: BSD-3-Clause
// An instructor's orders over HTTP, to simulations that are scripted but speak real DDS.
#include "tests/monitor/scripted_simulation.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

namespace http = boost::beast::http;
using nlohmann::json;
using testing::HasSubstr;

class SimulationOrdersTest : public ServerFixture {
 protected:
  HttpAnswer order(const json& body) { return post("/api/simulation/orders", body); }
  /// Orders until the monitor has heard a simulation.
  HttpAnswer order_once_heard(const json& body) {
    HttpAnswer answer;
    EXPECT_TRUE(becomes_true([&] { return (answer = order(body)).status != 404; }));
    return answer;
  }
  static std::string detail(const HttpAnswer& answer) {
    return answer.as_json().value("detail", "");
  }
};

TEST_F(SimulationOrdersTest, AnOrderIsAnsweredWithTheSimulationsOwnEvent) {
  const ScriptedSimulation office("office-1", test_domain());
  const auto answer = order_once_heard(
      {{"order", "move"}, {"subject", "io"}, {"x_m", 1.5}, {"y_m", 5}, {"author", "Ada"}});
  ASSERT_EQ(answer.status, 200U) << answer.body;
  const auto event = answer.as_json();
  EXPECT_EQ(event["done"], true);
  EXPECT_EQ(event["text"], "move is done");
  EXPECT_EQ(event["author"], "Ada");
  EXPECT_EQ(event["simulation"], "office-1");
  const auto heard = office.heard();
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard[0].id, event["order_id"]);
  EXPECT_EQ(heard[0].subject, "io");
  EXPECT_EQ(heard[0].x_m, 1.5);
  EXPECT_EQ(heard[0].y_m, 5);
  EXPECT_FALSE(heard[0].turns) << "no heading was given";
  EXPECT_EQ(order({{"order", "move"}, {"subject", "io"}, {"heading_rad", 0}}).status, 200U);
  EXPECT_TRUE(office.heard().back().turns);
}

TEST_F(SimulationOrdersTest, WhatTheSimulationRefusesComesBackWithItsReason) {
  const ScriptedSimulation office("office-1", test_domain());
  const auto answer = order_once_heard({{"order", "remove"}, {"subject", "can_1"}});
  EXPECT_EQ(answer.status, 409U);
  EXPECT_EQ(detail(answer), "nothing is removed here.");
  EXPECT_EQ(answer.as_json()["event"]["subject"], "can_1");
}

TEST_F(SimulationOrdersTest, WhereNoSimulationRunsAnOrderSaysSo) {
  const auto answer = order({{"order", "pause"}});
  EXPECT_EQ(answer.status, 404U);
  EXPECT_EQ(answer.type, "application/problem+json");
  EXPECT_THAT(detail(answer), HasSubstr("no simulation is heard"));
}

TEST_F(SimulationOrdersTest, OneOfSeveralMustBeNamed) {
  const ScriptedSimulation office("office-1", test_domain()), hall("hall-1", test_domain());
  EXPECT_TRUE(becomes_true([&] {
    return order({{"order", "pause"}, {"simulation", "hall-1"}}).status == 200;
  }));
  EXPECT_TRUE(becomes_true([&] {
    return detail(order({{"order", "pause"}})).find("hall-1, office-1") != std::string::npos;
  }));
  EXPECT_TRUE(office.heard().empty() || office.heard().back().order == "pause");
  EXPECT_THAT(detail(order({{"order", "pause"}, {"simulation", "attic"}})),
              HasSubstr("'attic' is not heard"));
}

TEST_F(SimulationOrdersTest, WhoMayNotSteerMayNotOrder) {
  const ScriptedSimulation office("office-1", test_domain());
  (void)order_once_heard({{"order", "pause"}});
  const auto before = office.heard().size();
  const std::string pause = R"({"order":"pause"})";
  EXPECT_EQ(request(http::verb::post, "/api/simulation/orders", pause).status, 403U);
  EXPECT_EQ(
      request(http::verb::post, "/api/simulation/orders", pause, bearer("viewer.token")).status,
      403U);
  EXPECT_EQ(office.heard().size(), before);
}

TEST_F(SimulationOrdersTest, ASilentSimulationIsAskedAgainAndOthersAreServedMeanwhile) {
  ScriptedSimulation office("office-1", test_domain());
  (void)order_once_heard({{"order", "pause"}});
  office.ignore_orders();
  HttpAnswer answer;
  std::thread asking([&] { answer = order({{"order", "go_on"}}); });
  const auto times_heard = [&] {
    return std::ranges::count(office.heard(), "go_on", &msg::SimulationOrder::order);
  };
  EXPECT_TRUE(becomes_true([&] { return times_heard() >= 2; }));
  EXPECT_EQ(get("/healthz").status, 200U);
  asking.join();
  EXPECT_EQ(answer.status, 503U);
  EXPECT_THAT(detail(answer), HasSubstr("'office-1' does not answer"));
}

}  // namespace
}  // namespace galilean::monitor
