// SPDX-License-Identifier: BSD-3-Clause
// Pushes over HTTP, to robots that are scripted but speak real DDS.
#include "tests/monitor/scripted_robot.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using PushingTest = ServerFixture;

TEST_F(PushingTest, APushReachesEachRobotAndIsRemembered) {
  ScriptedRobot io("io", test_domain(), catalog), ganymede("ganymede", test_domain(), catalog);
  ganymede.refuse_pushes("the serial line is down");
  wait_for_robots(2);
  const auto answer = post(
      "/api/push", {{"files", files(kProgram)}, {"author", "balch"}, {"targets", json::array()}});
  ASSERT_EQ(answer.status, 200U) << answer.body;
  const auto pushed = answer.as_json();
  ASSERT_EQ(pushed["replies"].size(), 2U);
  EXPECT_EQ(pushed["replies"][0]["robot"], "ganymede");
  EXPECT_EQ(pushed["replies"][0]["status"], "rejected");
  EXPECT_EQ(pushed["replies"][0]["message"], "the serial line is down");
  EXPECT_EQ(pushed["replies"][1]["status"], "running");
  EXPECT_EQ(pushed["replies"][1]["kept_variables"], json::array({"shaft"}));
  EXPECT_EQ(io.running_hash(), pushed["hash"]);
  EXPECT_EQ(ganymede.running_hash(), "first");

  ASSERT_TRUE(becomes_true([&] {
    const auto pushes = get("/api/pushes").as_json()["pushes"];
    return pushes.size() == 1 && pushes[0]["replies"].size() == 2;
  }));
  EXPECT_EQ(get("/api/pushes").as_json()["pushes"][0]["author"], "balch");
  EXPECT_EQ(get("/api/pushed/" + pushed["hash"].get<std::string>()).as_json()["files"][0]["text"],
            kProgram);
  ASSERT_TRUE(becomes_true([&] {
    const auto robots = get("/api/status").as_json()["robots"];
    return robots.at(0)["name"] == "ganymede" && robots.at(0)["drifting"].get<bool>();
  }));
}

TEST_F(PushingTest, WhatWasNotSentAndIsTakenFromTheMonitorsProgramsIsToldAndRemembered) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const json sent{{"files", files("include \"parts.bhdl\"\n")}};
  const auto from = (folder / "programs" / "parts.bhdl").string();
  const json taken = json::array({{{"path", "parts.bhdl"}, {"from", from}}});
  EXPECT_EQ(post("/api/check", sent).as_json()["taken"], taken);
  EXPECT_EQ(post("/api/check", {{"files", files(kProgram)}}).as_json()["taken"], json::array());
  const auto answer = post("/api/push", sent);
  ASSERT_EQ(answer.status, 200U) << answer.body;
  const auto detail = answer.as_json()["steps"][0]["detail"].get<std::string>();
  EXPECT_EQ(detail, "not sent with it, and taken from the monitor's programs: " + from);
  EXPECT_TRUE(becomes_true([&] {
    const auto pushes = get("/api/pushes").as_json()["pushes"];
    return pushes.size() == 1 && pushes[0]["steps"][0]["detail"] == detail;
  }));
  const auto broken = post("/api/push", {{"files", files("include \"parts.bhdl\"\nnonsense")}});
  EXPECT_EQ(broken.as_json()["taken"], taken);
}

TEST_F(PushingTest, APushToTheTeamFailsAtARobotThatIsAwayAndTheHistoryNamesIt) {
  ScriptedRobot io("io", test_domain(), catalog);
  auto ganymede = std::make_unique<ScriptedRobot>("ganymede", test_domain(), catalog);
  wait_for_robots(2);
  ganymede.reset();
  ASSERT_TRUE(becomes_true(
      [&] { return get("/api/status").as_json()["robots"][0]["silent"].get<bool>(); }));
  const auto pushed = post("/api/push", {{"files", files(kProgram)}}).as_json();
  EXPECT_EQ(pushed["state"], "failed");
  EXPECT_EQ(pushed["steps"].back()["detail"], "ganymede has not answered");
  EXPECT_EQ(io.running_hash(), pushed["hash"]) << "the others run it";
  ASSERT_TRUE(becomes_true([&] {
    const auto pushes = get("/api/pushes").as_json()["pushes"];
    return pushes.at(0)["state"] == "failed" && pushes.at(0)["replies"].size() == 2;
  }));
  EXPECT_EQ(get("/api/pushes").as_json()["pushes"][0]["replies"][0]["status"], "no_answer");
}

TEST_F(PushingTest, ABrokenProgramIsPushedToNobody) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const auto answer = post("/api/push", {{"files", files(kBroken)}});
  EXPECT_EQ(answer.status, 422U);
  EXPECT_GE(answer.as_json()["diagnostics"].size(), 2U);
  EXPECT_EQ(io.running_hash(), "first");
  EXPECT_TRUE(get("/api/pushes").as_json()["pushes"].empty());
}

TEST_F(PushingTest, TheOthersGetAProgramOnceTheCanaryHasProvedIt) {
  ScriptedRobot io("io", test_domain(), catalog), ganymede("ganymede", test_domain(), catalog);
  wait_for_robots(2);
  const auto answer =
      post("/api/push", {{"files", files(kProgram)}, {"canary", "io"}, {"probation_s", 0.5}});
  ASSERT_EQ(answer.status, 202U) << answer.body;
  const auto push = answer.as_json();
  EXPECT_TRUE(becomes_true([&] { return io.running_hash() == push["hash"]; }));
  EXPECT_EQ(ganymede.running_hash(), "first");
  ASSERT_TRUE(becomes_true([&] { return push_named(push["id"])["state"] == "done"; }));
  EXPECT_EQ(ganymede.running_hash(), push["hash"]);
  const auto done = push_named(push["id"]);
  EXPECT_EQ(done["steps"][2]["state"], "done");
  EXPECT_EQ(done["replies"].size(), 2U);
  EXPECT_EQ(get("/api/pushes/nothing").status, 404U);
}

TEST_F(PushingTest, WhileOnePushesTheOtherIsToldWhoAndWhat) {
  ScriptedRobot io("io", test_domain(), catalog), ganymede("ganymede", test_domain(), catalog);
  wait_for_robots(2);
  const auto answer = post(
      "/api/push",
      {{"files", files(kProgram)}, {"author", "balch"}, {"canary", "io"}, {"probation_s", 60}});
  const auto push = answer.as_json();
  EXPECT_TRUE(becomes_true([&] { return io.running_hash() == push["hash"]; }));

  const auto second = post("/api/push", {{"files", files(kProgram)}, {"targets", {"ganymede"}}});
  EXPECT_EQ(second.status, 409U);
  EXPECT_THAT(second.as_json()["detail"].get<std::string>(),
              HasSubstr("balch is pushing pushed.bhdl ("));
  EXPECT_EQ(second.as_json()["pushed"]["id"], push["id"]);
  EXPECT_EQ(second.as_json()["running_hash"], "first");
  EXPECT_THAT(second.as_json()["detail"].get<std::string>(),
              HasSubstr("Now runs first, which was not pushed through this monitor."));

  const std::string cancel = "/api/pushes/" + push["id"].get<std::string>() + "/cancel";
  const auto cancelled = post(cancel, {{"author", "collins"}});
  EXPECT_EQ(cancelled.status, 200U) << cancelled.body;
  EXPECT_EQ(cancelled.as_json()["steps"][2]["detail"], "cancelled by collins");
  EXPECT_TRUE(becomes_true([&] { return io.running_hash() == "first"; })) << "it is taken back";
  EXPECT_TRUE(becomes_true([&] {
    const auto reply = push_named(push["id"])["replies"][0];
    return reply["status"] == "rolled_back" && reply["message"] == "cancelled by collins";
  }));
  EXPECT_EQ(ganymede.running_hash(), "first");
  EXPECT_EQ(post(cancel, json::object()).status, 409U);
  EXPECT_EQ(post("/api/pushes/nothing/cancel", json::object()).status, 404U);
  ASSERT_TRUE(becomes_true([&] {
    return std::ranges::any_of(get("/api/pushes").as_json()["pushes"], [&](const auto& each) {
      return each["id"] == push["id"] && each["state"] == "cancelled";
    });
  }));
}

TEST_F(PushingTest, ARobotOutOfServiceIsPushedToOnlyByItsName) {
  ScriptedRobot io("io", test_domain(), catalog), callisto("callisto", test_domain(), catalog);
  wait_for_robots(2);
  ASSERT_EQ(post("/api/command", {{"kind", "decommission"}, {"targets", {"callisto"}}}).status,
            200U);
  ASSERT_TRUE(becomes_true(
      [&] { return get("/api/status").as_json()["robots"][0]["out_of_service"].get<bool>(); }));
  const auto to_all = post("/api/push", {{"files", files(kProgram)}});
  ASSERT_EQ(to_all.status, 200U) << to_all.body;
  EXPECT_EQ(to_all.as_json()["state"], "done") << "nobody waits for it";
  ASSERT_EQ(to_all.as_json()["replies"].size(), 1U);
  EXPECT_EQ(to_all.as_json()["replies"][0]["robot"], "io");
  EXPECT_EQ(callisto.running_hash(), "first");
  EXPECT_FALSE(get("/api/status").as_json()["robots"][0]["drifting"].get<bool>());

  const auto by_name = post("/api/push", {{"files", files(kProgram)}, {"targets", {"callisto"}}});
  ASSERT_EQ(by_name.status, 200U) << by_name.body;
  EXPECT_EQ(callisto.running_hash(), by_name.as_json()["hash"]);
  ASSERT_EQ(post("/api/command", {{"kind", "commission"}}).status, 200U);
  EXPECT_TRUE(becomes_true([&] { return !callisto.out_of_service(); }));
}

TEST_F(PushingTest, AStalePageIsToldWhoPushedWhat) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  EXPECT_EQ(
      post("/api/push", {{"files", files(kProgram)}, {"author", "balch"}, {"replaces", "first"}})
          .status,
      200U);
  ASSERT_TRUE(becomes_true([&] {
    return get("/api/status").as_json()["robots"][0]["program_hash"] == io.running_hash();
  }));
  const auto stale = post("/api/push", {{"files", files(kProgram)}, {"replaces", "first"}});
  EXPECT_EQ(stale.status, 409U);
  EXPECT_THAT(stale.as_json()["detail"].get<std::string>(), HasSubstr("which balch pushed at "));
  EXPECT_EQ(stale.as_json()["running_hash"], io.running_hash());
}

}  // namespace
}  // namespace galilean::monitor
