// SPDX-License-Identifier: BSD-3-Clause
// The monitor as its users meet it: over HTTP and Foxglove's protocol, with robots that are
// scripted but speak real DDS.
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "monitor/access/tokens.h"
#include "tests/monitor/scripted_robot.h"
#include "tests/monitor/server/foxglove/foxglove_socket.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

namespace http = boost::beast::http;
using nlohmann::json;
using testing::HasSubstr;
using testing::UnorderedElementsAre;
using ServerTest = ServerFixture;

TEST_F(ServerTest, ServesThePageHealthAndMetrics) {
  EXPECT_EQ(get("/").status, 200U);
  EXPECT_EQ(get("/healthz").body, "ok\n");
  EXPECT_THAT(get("/metrics").body, HasSubstr("\ngalilean_robots 0\n"));
  EXPECT_EQ(request(http::verb::head, "/").body, "");
}

TEST_F(ServerTest, RefusesStrangersOnHttpAndWebSocket) {
  const auto rebound = request(http::verb::get, "/api/status", {}, {{"Host", "evil.example"}});
  EXPECT_EQ(rebound.status, 403U);
  EXPECT_EQ(rebound.type, "application/problem+json");
  EXPECT_EQ(request(http::verb::post, "/api/command", R"({"kind":"hold"})",
                    {{"Origin", "https://evil.example"}})
                .status,
            403U);
  EXPECT_THROW(FoxgloveSocket("evil.example", monitor->port()), boost::system::system_error);
  EXPECT_THROW(FoxgloveSocket(host(), monitor->port(), "https://evil.example"),
               boost::system::system_error);
}

TEST_F(ServerTest, WhoHasNoOperatorsTokenMayReadHereAndSteerNothing) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  const auto hold = R"({"kind":"hold"})";
  const auto nobody = request(http::verb::post, "/api/command", hold);
  EXPECT_EQ(nobody.status, 403U);
  EXPECT_THAT(nobody.as_json()["detail"].get<std::string>(), HasSubstr("operator.token"));
  EXPECT_EQ(request(http::verb::post, "/api/command", hold, bearer("viewer.token")).status, 403U);
  EXPECT_EQ(request(http::verb::post, "/api/command", hold, {{"Authorization", "Bearer x"}}).status,
            403U);
  EXPECT_EQ(get("/api/status").status, 200U) << "on loopback reading is free";
  const auto may_steer = [&](auto... token) {
    return request(http::verb::get, "/api/status", {}, token...).as_json()["may_steer"];
  };
  EXPECT_EQ(may_steer(), false);
  EXPECT_EQ(may_steer(bearer("viewer.token")), false);
  EXPECT_EQ(may_steer(bearer("operator.token")), true);
  const auto open_door = run_command(std::string(GALILEAN_SWAP) + " --monitor http://" + host() +
                                     " --token-file " + (folder / "viewer.token").string() +
                                     " --team " + (folder / "good.bhdl").string());
  EXPECT_EQ(open_door.exit_code, 1);
  EXPECT_THAT(open_door.output, HasSubstr("operator's token"));
  EXPECT_EQ(io.running_hash(), "first");
  EXPECT_FALSE(io.held());

  FoxgloveSocket reader(host(), monitor->port());
  std::size_t service = 0;
  const auto services = reader.read_op("advertiseServices")["services"];
  for (const auto& each : services)
    if (each["name"] == "/galilean/hold") service = each["id"];
  const std::string call{2, static_cast<char>(service), 0, 0, 0, 5, 0, 0, 0, 4, 0, 0, 0};
  reader.send_binary(call + "json{}");
  EXPECT_THAT(reader.read_op("serviceCallFailure")["message"].get<std::string>(),
              HasSubstr("operator's token"));
}

TEST_F(ServerTest, TellsWhatIsWrongWithARequest) {
  EXPECT_EQ(get("/api/nothing").status, 404U);
  EXPECT_EQ(get("/api/programs/nothing.bhdl").status, 404U);
  EXPECT_EQ(get("/api/programs/..%2F..%2Fetc%2Fpasswd").status, 404U);
  EXPECT_EQ(get("/api/map.png").status, 404U);
  EXPECT_EQ(get("/api/push").status, 405U);
  for (const char* path : {"/ws", "/lsp", "/replay?recording=x"}) {
    const auto answer = get(path);
    EXPECT_EQ(answer.status, 426U) << path;
    EXPECT_THAT(answer.as_json()["detail"].get<std::string>(), HasSubstr("is for WebSockets"));
  }
  EXPECT_EQ(request(http::verb::post, "/api/push", "{", bearer("operator.token")).status, 400U);
  EXPECT_EQ(post("/api/push", {{"files", 3}}).status, 400U);
  EXPECT_EQ(post("/api/check", json::object()).status, 400U);
  EXPECT_EQ(post("/api/command", {{"kind", "dance"}}).status, 400U);
  const auto nobody = post("/api/push", {{"files", files(kProgram)}});
  EXPECT_EQ(nobody.status, 409U);
  EXPECT_THAT(nobody.as_json()["detail"].get<std::string>(), HasSubstr("No robot is heard"));
  EXPECT_EQ(post("/api/push", {{"files", files(kProgram)}, {"targets", {"io"}}}).status, 404U);
}

TEST_F(ServerTest, ListsReadsAndChecksPrograms) {
  const auto list = get("/api/programs").as_json()["programs"];
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0]["name"], "main.bhdl");
  EXPECT_EQ(list[0]["source"], "shipped");
  EXPECT_EQ(get("/api/programs/main.bhdl").as_json()["files"].size(), 2U);

  const auto good = post("/api/check", {{"files", files("include \"parts.bhdl\"\n")}}).as_json();
  EXPECT_EQ(good["ok"], true) << good.dump();
  EXPECT_EQ(good["machine"]["states"][0]["name"], "start");
  const json same{{"files", files("include \"parts.bhdl\"\n")},
                  {"against", files("; a comment\ninclude \"parts.bhdl\"\n")}};
  EXPECT_EQ(post("/api/check", same).as_json()["changes"], json::array());
  const json other{
      {"files", files("include \"parts.bhdl\"\nstates: state: name: \"more\" end end\n")},
      {"against", files("include \"parts.bhdl\"\n")}};
  const auto changed = post("/api/check", other).as_json();
  ASSERT_EQ(changed["changes"].size(), 1U) << changed.dump();
  EXPECT_THAT(changed["changes"][0].get<std::string>(), HasSubstr("more"));
  const auto broken = post("/api/check", {{"files", files(kBroken)}}).as_json();
  EXPECT_EQ(broken["ok"], false);
  EXPECT_EQ(broken["diagnostics"][0]["file"], "pushed.bhdl");
  EXPECT_EQ(broken["diagnostics"][0]["line"], 3);
}

TEST_F(ServerTest, HoldStopsTheRobotsThatAreNamed) {
  ScriptedRobot io("io", test_domain(), catalog), ganymede("ganymede", test_domain(), catalog);
  wait_for_robots(2);
  EXPECT_EQ(post("/api/command", {{"kind", "hold"}, {"targets", {"io"}}}).status, 200U);
  EXPECT_TRUE(becomes_true([&] { return io.held(); }));
  EXPECT_FALSE(ganymede.held());
  EXPECT_EQ(post("/api/command", {{"kind", "resume"}}).status, 200U);
  EXPECT_TRUE(becomes_true([&] { return !io.held(); }));
}

TEST_F(ServerTest, AFoxgloveClientReadsStatesEventsAndCallsServices) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  FoxgloveSocket socket(host(), monitor->port(), {},
                        "/ws?token=" + read_token(folder / "operator.token").value());
  EXPECT_EQ(socket.response[http::field::sec_websocket_protocol], "foxglove.websocket.v1");
  const auto services = socket.read_op("advertiseServices")["services"];
  std::vector<std::string> names;
  for (const auto& service : services) names.push_back(service["name"]);
  EXPECT_THAT(names,
              UnorderedElementsAre("/galilean/push", "/galilean/cancel_push", "/galilean/hold",
                                   "/galilean/resume", "/galilean/step", "/galilean/push_bumper",
                                   "/galilean/decommission", "/galilean/commission",
                                   "/galilean/breaks", "/galilean/lease"));
  const auto states = socket.channel("/io/state");
  socket.send({{"op", "subscribe"}, {"subscriptions", {{{"id", 40}, {"channelId", states}}}}});
  const auto message = socket.read();
  ASSERT_EQ(message[0], 1);
  ASSERT_EQ(message[1], 40);
  msg::RobotState state;
  ASSERT_TRUE(msg::decode_cdr(
      std::span(reinterpret_cast<const std::uint8_t*>(message.data()) + 13, message.size() - 13),
      state));
  EXPECT_EQ(state.robot, "io");

  std::size_t hold = 0;
  for (const auto& service : services)
    if (service["name"] == "/galilean/hold") hold = service["id"];
  const std::string call{2, static_cast<char>(hold), 0, 0, 0, 5, 0, 0, 0, 4, 0, 0, 0};
  socket.send_binary(call + "json{}");
  EXPECT_TRUE(becomes_true([&] { return io.held(); }));
  std::string answer;
  while (answer.empty() || answer[0] != 3) answer = socket.read();
  EXPECT_EQ(answer[5], 5);
  EXPECT_THAT(answer, HasSubstr("json{\"id\":"));
}

TEST_F(ServerTest, AClientThatDoesNotReadItsEventsIsToldSoAndNobodyWaitsForIt) {
  const auto noisy = wire::Participant::join("noisy", test_domain()).value();
  wire::Writer<msg::Log> log(*noisy, wire::kLogTopic);
  FoxgloveSocket slow(host(), monitor->port()), quick(host(), monitor->port());
  for (auto* each : {&slow, &quick}) each->subscribe(each->channel("/rosout"));
  msg::Log entry;
  entry.msg = std::string(60 << 10, 'x');
  for (int i = 0; i < 860; ++i) {  // more than the outbox and the sockets take
    ASSERT_TRUE(log.write(entry));
    EXPECT_GT(quick.read().size(), entry.msg.size());
  }
  EXPECT_THAT(slow.read_to_the_end(), HasSubstr("too slow"));
  EXPECT_THAT(get("/metrics").body, HasSubstr("\ngalilean_websocket_dismissed_total 1\n"));
}

TEST_F(ServerTest, ARobotThatEndsStaysAndIsSilent) {
  {
    ScriptedRobot io("io", test_domain(), catalog);
    wait_for_robots(1);
  }
  EXPECT_TRUE(becomes_true(
      [&] { return get("/api/status").as_json()["robots"][0]["silent"].get<bool>(); }));
  EXPECT_EQ(get("/api/team").as_json()["robots"][0]["state"], "start");
}

TEST_F(ServerTest, APortThatIsTakenOrABadAddressIsOneLine) {
  const std::string start = std::string(GALILEAN_MONITOR) + " --domain " +
                            std::to_string(test_domain()) + " --data " +
                            (folder / "second").string() + " --listen ";
  const std::vector<std::pair<std::string, int>> endings{{host(), 1},
                                                         {"203.0.113.1:8080 --plain", 1},
                                                         {"203.0.113.1:8080", 2},
                                                         {"nowhere:1 --plain", 1},
                                                         {"127.0.0.1:99999", 2}};
  for (const auto& [where, exit_code] : endings) {
    const auto ended = run_command(start + where);
    EXPECT_EQ(ended.exit_code, exit_code) << where << ": " << ended.output;
    EXPECT_LE(std::ranges::count(ended.output, '\n'), 2) << ended.output;
  }
  EXPECT_EQ(run_command(start + "127.0.0.1:0 --domain 999").exit_code, 2);
}

/// A monitor that keeps its history in the folder of a user, which others use as well.
class SharedFolderTest : public ServerFixture {
 protected:
  void change(MonitorOptions& options) override { options.shares_data_folder = true; }
};

TEST_F(SharedFolderTest, AMonitorKeepsItsHistoryApartAndTheTokensTogether) {
  const auto own = folder / "histories" / ("domain-" + std::to_string(test_domain()) + "-port-0") /
                   "history.sqlite";
  EXPECT_TRUE(std::filesystem::exists(own)) << own;
  EXPECT_FALSE(std::filesystem::exists(folder / "history.sqlite"));
  EXPECT_TRUE(std::filesystem::exists(folder / "operator.token"));
}

}  // namespace
}  // namespace galilean::monitor
