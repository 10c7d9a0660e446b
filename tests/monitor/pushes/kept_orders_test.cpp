// SPDX-License-Identifier: BSD-3-Clause
// What was acknowledged is kept, and what is kept agrees with what robots run: over HTTP, to robots
// that are scripted but speak real DDS.
#include <thread>

#include "core/wire/participant.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "monitor/pushes/history/history.h"
#include "monitor/pushes/history/push_messages.h"
#include "tests/monitor/scripted_robot.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using KeptOrdersTest = ServerFixture;

TEST_F(KeptOrdersTest, AnOrderThatComesTwiceIsOnePushWithOneAnswer) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const json order{{"files", files(kProgram)}, {"author", "balch"}, {"id", "order-0001"}};
  const auto first = post("/api/push", order);
  ASSERT_EQ(first.status, 200U) << first.body;
  EXPECT_EQ(first.as_json()["id"], "order-0001");
  auto repeated = order;
  repeated["author"] = "collins";
  const auto second = post("/api/push", repeated);
  EXPECT_EQ(second.status, 200U) << second.body;
  EXPECT_EQ(second.as_json()["author"], "balch") << "it is the first one's answer";
  EXPECT_EQ(get("/api/pushes").as_json()["pushes"].size(), 1U);
}

TEST_F(KeptOrdersTest, AnOrderThatWasRefusedIsRefusedAgainThoughItWouldPassNow) {
  const json order{{"files", files(kProgram)}, {"targets", {"io"}}, {"id", "order-0002"}};
  EXPECT_EQ(post("/api/push", order).status, 404U);
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  EXPECT_EQ(post("/api/push", order).status, 404U);
  EXPECT_EQ(io.running_hash(), "first");
  for (const auto* id : {"short", "with a space", "../../etc/passwd"})
    EXPECT_EQ(post("/api/push", {{"files", files(kProgram)}, {"id", id}}).status, 400U) << id;
}

TEST_F(KeptOrdersTest, TheSecondOfTwoThatReplaceTheSameProgramIsToldWhoseRunsAtOnce) {
  ScriptedRobot io("io", test_domain(), catalog), ganymede("ganymede", test_domain(), catalog);
  wait_for_robots(2);
  for (const auto& targets : {json::array(), json::array({"io"})}) {
    const auto runs = io.running_hash();
    const std::string text = std::string(kProgram) + "; " + targets.dump() + "\n";
    json order{{"files", files(text.c_str())}, {"targets", targets}, {"replaces", runs}};
    order["author"] = "balch";
    const auto first = post("/api/push", order);
    ASSERT_EQ(first.status, 200U) << first.body;
    // No state of a robot can have come since.
    order["author"] = "collins";
    const auto second = post("/api/push", order);
    EXPECT_EQ(second.status, 409U) << second.body;
    EXPECT_EQ(second.as_json()["running_hash"], first.as_json()["hash"]);
    EXPECT_EQ(second.as_json()["running_pushed"]["author"], "balch");
  }
}

TEST_F(KeptOrdersTest, OfTwoAtTheSameTimeTheSecondIsToldTheFirstOnesHashAndAuthor) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  std::vector<HttpAnswer> answers(2);
  std::vector<std::thread> operators;
  for (std::size_t number = 0; number < answers.size(); ++number)
    operators.emplace_back([&, number] {
      const std::string text = std::string(kProgram) + "; " + std::to_string(number) + "\n";
      answers[number] = post("/api/push", {{"files", files(text.c_str())},
                                           {"author", "operator " + std::to_string(number)},
                                           {"replaces", "first"}});
    });
  for (auto& each : operators) each.join();
  const std::size_t lost = answers[0].status == 409U ? 0 : 1;
  const auto& won = answers[1 - lost];
  EXPECT_EQ(won.status, 200U) << won.body;
  ASSERT_EQ(answers[lost].status, 409U) << answers[lost].body;
  const json refusal = answers[lost].as_json();
  const json first = won.as_json();
  EXPECT_EQ(refusal["pushed"]["hash"], first["hash"]);
  EXPECT_EQ(refusal["pushed"]["author"], first["author"]);
  EXPECT_THAT(refusal["detail"].get<std::string>(),
              HasSubstr(first["hash"].get<std::string>().substr(0, 8)));
}

TEST_F(KeptOrdersTest, AnOrderThatComesAgainGetsItsAnswerWhoeverHasTheLeaseByThen) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const auto post_as = [this](const std::string& name, const std::string& target,
                              const json& body) {
    auto headers = bearer("operator.token");
    headers["X-Galilean-Operator"] = name;
    headers["X-Galilean-Client"] = name + "s tab";
    return request(boost::beast::http::verb::post, target, body.dump(), headers);
  };
  const json order{{"files", files(kProgram)}, {"targets", {"io"}}, {"id", "order-0004"}};
  const auto first = post_as("ada", "/api/push", order);
  ASSERT_EQ(first.status, 200U) << first.body;
  const json take{{"do", "take"}, {"robots", {"io"}}, {"reason", "it is on fire"}};
  ASSERT_EQ(post_as("ben", "/api/lease", take).status, 200U);
  const auto again = post_as("ada", "/api/push", order);
  EXPECT_EQ(again.status, 200U) << again.body;
  EXPECT_EQ(again.as_json()["hash"], first.as_json()["hash"]);
  auto another = order;
  another["id"] = "order-0005";
  EXPECT_EQ(post_as("ada", "/api/push", another).status, 409U);
  EXPECT_EQ(get("/api/pushes").as_json()["pushes"].size(), 1U);
}

TEST_F(KeptOrdersTest, AProgramWithErrorsKeepsNobodyWaitingForLong) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  HttpAnswer broken, whole;
  std::thread first([&] { broken = post("/api/push", {{"files", files(kBroken)}}); });
  std::thread second([&] { whole = post("/api/push", {{"files", files(kProgram)}}); });
  first.join();
  second.join();
  EXPECT_TRUE(broken.status == 422U || broken.status == 409U) << broken.body;
  EXPECT_EQ(whole.status, 200U) << whole.body;
}

TEST_F(KeptOrdersTest, ARefusedPushIsListedWithWhoAndWhy) {
  const json order{{"files", files(kProgram)}, {"author", "balch"}, {"id", "order-0003"}};
  EXPECT_EQ(post("/api/push", order).status, 409U) << "no robot is heard";
  const json listed = get("/api/orders").as_json();
  ASSERT_EQ(listed["orders"].size(), 1U) << listed.dump();
  EXPECT_EQ(listed["orders"][0]["id"], "order-0003");
  EXPECT_EQ(listed["orders"][0]["kind"], "push");
  EXPECT_EQ(listed["orders"][0]["author"], "balch");
  EXPECT_THAT(listed["orders"][0]["outcomes"][0]["outcome"].get<std::string>(),
              HasSubstr("refused: No robot is heard"));
}

TEST_F(KeptOrdersTest, EveryOrderIsKeptWithWhoWhenAndWhatBecameOfIt) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const auto order = [&](const json& body) {
    const auto answer = post("/api/command", body);
    EXPECT_EQ(answer.status, 200U) << answer.body;
    EXPECT_FALSE(answer.as_json().contains("not_kept"));
    return answer.as_json()["id"].get<std::string>();
  };
  const auto kept = [&](const std::string& id) {
    for (const auto& each : list_in("/api/orders", "orders"))
      if (each["id"] == id) return each;
    return json();
  };
  // What is sent before DDS has matched writer and reader is lost.
  ASSERT_TRUE(becomes_true([&] {
    (void)order({{"kind", "hold"}, {"author", "nobody"}});
    return io.held();
  }));
  const auto id = order({{"kind", "hold"}, {"author", "balch"}, {"targets", {"io"}}});
  const auto held = kept(id);
  ASSERT_TRUE(held.is_object()) << "it is there as soon as it is answered";
  EXPECT_EQ(held["author"], "balch");
  EXPECT_EQ(held["kind"], "hold");
  EXPECT_EQ(held["targets"], json::array({"io"}));
  EXPECT_GT(held["ordered_ns"], 0);
  ASSERT_TRUE(becomes_true([&] { return kept(id)["outcomes"].size() == 1; }));
  EXPECT_EQ(kept(id)["outcomes"][0]["of"], "io");
  EXPECT_EQ(kept(id)["outcomes"][0]["outcome"], "is held");

  // A scripted robot does not answer orders about breaks.
  const auto breaks = post("/api/breaks", {{"order", "clear"}, {"author", "collins"}});
  ASSERT_EQ(breaks.status, 200U);
  const auto cleared = breaks.as_json()["id"].get<std::string>();
  EXPECT_EQ(kept(cleared)["kind"], "breaks: clear");
  ASSERT_TRUE(becomes_true([&] { return kept(cleared)["outcomes"].size() == 1; }));
  EXPECT_THAT(kept(cleared)["outcomes"][0]["outcome"].get<std::string>(),
              HasSubstr("did not confirm it"));
}

TEST_F(KeptOrdersTest, AFloodOfOrdersOfOthersIsCountedAndDoesNotFillTheHistory) {
  const auto stranger = wire::Participant::join("stranger", test_domain());
  ASSERT_TRUE(stranger);
  wire::Writer<msg::Command> commands(*stranger.value(), wire::kCommandTopic);
  int number = 0;
  const auto is_counted = [&] {
    for (int i = 0; i < 20; ++i) {
      msg::Command command;
      command.id = "flood " + std::to_string(++number);
      command.author = "stranger";
      command.kind = msg::Command_Constants::HOLD;
      command.targets = {"nobody"};
      EXPECT_TRUE(commands.write(command));
    }
    return get("/api/status").body.find("more orders than others give by hand") !=
           std::string::npos;
  };
  ASSERT_TRUE(becomes_true(is_counted, std::chrono::seconds(20)));
  EXPECT_LE(get("/api/orders").as_json()["orders"].size(), 200U);

  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const auto own =
      post("/api/command", {{"kind", "hold"}, {"author", "balch"}, {"targets", {"io"}}});
  ASSERT_EQ(own.status, 200U) << own.body;
  EXPECT_FALSE(own.as_json().contains("not_kept"));
  EXPECT_EQ(get("/api/orders").as_json()["orders"][0]["author"], "balch") << "one's own is kept";
}

TEST_F(KeptOrdersTest, AVeryLongPushOfOthersIsCountedAndNotKept) {
  const auto stranger = wire::Participant::join("stranger", test_domain());
  ASSERT_TRUE(stranger);
  wire::Writer<msg::ProgramPush> pushes(*stranger.value(), wire::kProgramPushTopic);
  msg::ProgramPush push;
  push.author = "stranger";
  push.files.push_back({"long.bhdl", std::string(std::size_t{2} << 20, ' ')});
  int number = 0;
  ASSERT_TRUE(becomes_true([&] {
    push.id = "long-push-" + std::to_string(++number);
    EXPECT_TRUE(pushes.write(push));
    return get("/api/status").body.find("programs of more than 1 MB") != std::string::npos;
  }));
  EXPECT_EQ(get("/api/pushes").as_json()["pushes"].size(), 0U);
}

TEST_F(KeptOrdersTest, TheHistoryIsVerifiedAndItsDiskIsWatched) {
  ASSERT_TRUE(becomes_true(
      [&] { return get("/metrics").body.find("galilean_history_whole 1") != std::string::npos; }));
  EXPECT_THAT(get("/metrics").body, HasSubstr("galilean_history_disk_well 1"));
  EXPECT_EQ(get("/api/status").as_json()["history_problem"], "");
  EXPECT_EQ(get("/api/pushes").as_json()["problem"], "");
  const auto ran =
      run_command(std::string(GALILEAN_PROGRAMS) + " verify --data " + folder.path().string());
  EXPECT_EQ(ran.exit_code, 0) << ran.output;
  EXPECT_THAT(ran.output, HasSubstr("The history is whole"));
  const auto none = run_command(std::string(GALILEAN_PROGRAMS) + " verify --data " +
                                (folder / "programs").string());
  EXPECT_EQ(none.exit_code, 3) << none.output;
}

/// A monitor whose predecessor was killed after it had sent a push to io, and one whose push failed
/// because io had not answered.
class TakenOverTest : public ServerFixture {
 protected:
  void change(MonitorOptions& options) override {
    const auto history = History::open(options.data_folder / "history.sqlite").value();
    msg::ProgramPush push;
    push.id = "killed";
    push.stamp = wire::ros_time(wire::wall_clock_ns());
    push.author = "balch";
    push.targets = {"io"};
    push.files = {{"sent.bhdl", kProgram}};
    hash = push.hash = hash_of_files(push);
    ASSERT_TRUE(history->add(push));
    ASSERT_TRUE(history->add_sending(
        push.id,
        {.state = PushState::kRunning,
         .steps = {{StepKind::kCheck, StepState::kDone}, {StepKind::kRest, StepState::kRunning}}},
        {"io"}));
    ASSERT_TRUE(history->add_refused_push({.id = "refused-push",
                                           .ordered_ns = 1,
                                           .author = "balch",
                                           .targets = {"io"},
                                           .program = "sent.bhdl",
                                           .reason = "conflict",
                                           .message = "It was refused then."}));
  }
  [[nodiscard]] bool is_told_later() {
    const auto push = push_named("killed");
    return push["state"] == "told_later" && push["told_ns"] > 0 &&
           push["replies"][0]["status"] == "confirmed";
  }

  std::string hash;
};

TEST_F(TakenOverTest, APushThatWasInterruptedIsConfirmedByTheRobotsState) {
  ASSERT_EQ(push_named("killed")["state"], "interrupted");
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  io.run_silently(hash);
  EXPECT_TRUE(becomes_true([&] { return is_told_later(); }));
}

TEST_F(TakenOverTest, AnOrderThatComesAgainGetsTheAnswerOfTheFormerMonitorAndDoesNothing) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const auto refused = post("/api/push", {{"files", files(kProgram)}, {"id", "refused-push"}});
  EXPECT_EQ(refused.status, 409U) << refused.body;
  EXPECT_EQ(refused.as_json()["detail"], "It was refused then.");
  EXPECT_EQ(get("/api/pushes").as_json()["pushes"].size(), 1U);
  EXPECT_EQ(io.running_hash(), "first");
}

TEST_F(TakenOverTest, ARobotThatWentBackUnheardIsToldToRunAnotherProgram) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  io.answer("killed", hash, msg::ProgramReply_Constants::RUNNING);
  EXPECT_TRUE(becomes_true([&] {
    const auto reply = push_named("killed")["replies"][0];
    return reply["status"] == "rolled_back" &&
           reply["message"].get<std::string>().find("another program: first") != std::string::npos;
  }));
  EXPECT_EQ(push_named("killed")["state"], "interrupted");
}

TEST_F(TakenOverTest, APushThatWasInterruptedIsConfirmedByALateAnswer) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  io.confirm("killed", hash);
  EXPECT_TRUE(becomes_true([&] { return is_told_later(); }));
}

TEST_F(TakenOverTest, APushThatANewerOneWentOverIsNotTakenForIt) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const json same = json::array({{{"path", "sent.bhdl"}, {"text", kProgram}}});
  const auto newer = post("/api/push", {{"files", same}, {"targets", {"io"}}});
  ASSERT_EQ(newer.status, 200U) << newer.body;
  ASSERT_EQ(newer.as_json()["hash"], hash);
  ASSERT_TRUE(becomes_true(
      [&] { return get("/api/status").as_json()["robots"][0]["program_hash"] != "first"; }));
  EXPECT_EQ(push_named("killed")["state"], "interrupted") << "it runs what the newer one brought";
}

}  // namespace
}  // namespace galilean::monitor
