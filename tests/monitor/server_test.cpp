// The monitor as its users meet it: over HTTP, over Foxglove's protocol and by `galilean swap`,
// with robots that are scripted but speak real DDS.
#include "monitor/server/monitor.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "monitor/access/tokens.h"
#include "tests/monitor/scripted_robot.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace fs = std::filesystem;
using asio::ip::tcp;
using nlohmann::json;
using testing::HasSubstr;

/// One a process: tests that run side by side do not hear one another.
const int kDomain = 60 + getpid() % 150;
constexpr const char* kProgram = "states:\n  state:\n    name: \"start\"\n  end\nend\n";
constexpr const char* kBroken = "states:\n  state:\n    nme: \"start\"\n  end\n  nonsense\nend\n";

struct Answer {
  unsigned status = 0;
  std::string body;
  std::string type;
  [[nodiscard]] json as_json() const { return json::parse(body, nullptr, false); }
};

/// What a command printed, and how it ended.
struct Ran {
  int exit_code = -1;
  std::string output;
};
Ran run(const std::string& command) {
  Ran result;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> part;
  while (const auto size = fread(part.data(), 1, part.size(), pipe))
    result.output.append(part.data(), size);
  result.exit_code = WEXITSTATUS(pclose(pipe));
  return result;
}

class ServerTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder / "programs");
    write("programs/main.bhdl", "include \"parts.bhdl\"\n");
    write("programs/parts.bhdl", kProgram);
    write("good.bhdl", kProgram);
    write("broken.bhdl", kBroken);
    MonitorOptions options;
    options.port = 0;
    options.domain = kDomain;
    options.data_folder = folder.path();
    options.library_folder = folder / "programs";
    options.catalog_file = folder / "catalog.json";
    write("catalog.json", catalog_to_json({}));
    auto made = Monitor::make(options);
    ASSERT_TRUE(made) << made.error().message;
    monitor = std::move(made).value();
    thread = std::thread([this] { monitor->run(); });
  }
  void TearDown() override {
    if (monitor) monitor->stop();
    if (thread.joinable()) thread.join();
    monitor.reset();
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
  }
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(monitor->port()); }

  Answer request(http::verb verb, const std::string& target, const std::string& body = {},
                 const std::map<std::string, std::string>& headers = {}) {
    asio::io_context io;
    tcp::socket socket(io);
    socket.connect({asio::ip::address_v4::loopback(), monitor->port()});
    http::request<http::string_body> message{verb, target, 11, body};
    message.set(http::field::host, host());
    for (const auto& [name, value] : headers) message.set(name, value);
    message.prepare_payload();
    http::write(socket, message);
    beast::flat_buffer buffer;
    http::response_parser<http::string_body> parser;
    parser.skip(verb == http::verb::head);
    http::read(socket, buffer, parser);
    const auto& answer = parser.get();
    return {answer.result_int(), answer.body(), std::string(answer[http::field::content_type])};
  }
  Answer get(const std::string& target) { return request(http::verb::get, target); }
  Answer post(const std::string& target, const json& body) {
    return request(http::verb::post, target, body.dump(), bearer("operator.token"));
  }
  [[nodiscard]] std::map<std::string, std::string> bearer(const std::string& file) const {
    return {{"Authorization", "Bearer " + read_token(folder / file).value()}};
  }
  json push_named(const std::string& id) { return get("/api/pushes/" + id).as_json(); }
  [[nodiscard]] static json files(const char* text) {
    return json::array({{{"path", "pushed.bhdl"}, {"text", text}}});
  }
  /// Asks until the answer suits, for at most five seconds.
  bool becomes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 250; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  }
  void wait_for_robots(std::size_t count) {
    ASSERT_TRUE(becomes_true([&] {
      const auto robots = get("/api/status").as_json()["robots"];
      return robots.size() == count && std::ranges::all_of(robots, [](const auto& robot) {
               return !robot["state"].template get<std::string>().empty();
             });
    }));
  }

  const TemporaryFolder folder;
  const std::string catalog = catalog_to_json({});
  std::unique_ptr<Monitor> monitor;
  std::thread thread;
};

/// A browser: speaks the protocol byte by byte.
class Socket {
 public:
  explicit Socket(const std::string& host, std::uint16_t port, const std::string& origin = {},
                  const std::string& target = "/ws")
      : stream_(io_) {
    beast::get_lowest_layer(stream_).connect({asio::ip::address_v4::loopback(), port});
    stream_.set_option(beast::websocket::stream_base::decorator([=](auto& message) {
      message.set(http::field::sec_websocket_protocol, "other, foxglove.websocket.v1");
      if (!origin.empty()) message.set(http::field::origin, origin);
    }));
    stream_.handshake(response, host, target);
  }
  void send(const json& message) {
    stream_.text(true);
    stream_.write(asio::buffer(message.dump()));
  }
  void send_binary(const std::string& bytes) {
    stream_.binary(true);
    stream_.write(asio::buffer(bytes));
  }
  /// The next message that is not the server's clock.
  std::string read() {
    for (;;) {
      beast::flat_buffer buffer;
      stream_.read(buffer);
      auto text = beast::buffers_to_string(buffer.data());
      if (stream_.got_text() || text[0] != 2) return text;
    }
  }
  json read_op(const std::string& op) {
    for (;;)
      if (auto message = json::parse(read(), nullptr, false);
          message.is_object() && message["op"] == op)
        return message;
  }
  std::uint32_t channel(const std::string& topic) {
    for (;;) {
      const auto channels = read_op("advertise")["channels"];
      for (const auto& channel : channels)
        if (channel["topic"] == topic) return channel["id"];
    }
  }
  beast::websocket::response_type response;

 private:
  asio::io_context io_;
  beast::websocket::stream<beast::tcp_stream> stream_;
};

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
  EXPECT_THROW(Socket("evil.example", monitor->port()), boost::system::system_error);
  EXPECT_THROW(Socket(host(), monitor->port(), "https://evil.example"),
               boost::system::system_error);
}

TEST_F(ServerTest, WhoHasNoOperatorsTokenMayReadHereAndSteerNothing) {
  ScriptedRobot io("io", kDomain, catalog);
  wait_for_robots(1);
  const auto hold = R"({"kind":"hold"})";
  const auto nobody = request(http::verb::post, "/api/command", hold);
  EXPECT_EQ(nobody.status, 403U);
  EXPECT_THAT(nobody.as_json()["detail"].get<std::string>(), HasSubstr("operator.token"));
  EXPECT_EQ(request(http::verb::post, "/api/command", hold, bearer("viewer.token")).status, 403U);
  EXPECT_EQ(request(http::verb::post, "/api/command", hold, {{"Authorization", "Bearer x"}}).status,
            403U);
  EXPECT_EQ(get("/api/status").status, 200U) << "on loopback reading is free";
  const auto open_door =
      run(std::string(GALILEAN_SWAP) + " --monitor http://" + host() + " --token-file " +
          (folder / "viewer.token").string() + " --team " + (folder / "good.bhdl").string());
  EXPECT_EQ(open_door.exit_code, 2);
  EXPECT_THAT(open_door.output, HasSubstr("operator's token"));
  EXPECT_EQ(io.running_hash(), "first");
  EXPECT_FALSE(io.held());

  Socket reader(host(), monitor->port());
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

TEST_F(ServerTest, APushReachesEachRobotAndIsRemembered) {
  ScriptedRobot io("io", kDomain, catalog), ganymede("ganymede", kDomain, catalog);
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

TEST_F(ServerTest, ABrokenProgramIsPushedToNobody) {
  ScriptedRobot io("io", kDomain, catalog);
  wait_for_robots(1);
  const auto answer = post("/api/push", {{"files", files(kBroken)}});
  EXPECT_EQ(answer.status, 422U);
  EXPECT_GE(answer.as_json()["diagnostics"].size(), 2U);
  EXPECT_EQ(io.running_hash(), "first");
  EXPECT_TRUE(get("/api/pushes").as_json()["pushes"].empty());
}

TEST_F(ServerTest, TheOthersGetAProgramOnceTheCanaryHasProvedIt) {
  ScriptedRobot io("io", kDomain, catalog), ganymede("ganymede", kDomain, catalog);
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

TEST_F(ServerTest, WhileOnePushesTheOtherIsToldWhoAndWhat) {
  ScriptedRobot io("io", kDomain, catalog), ganymede("ganymede", kDomain, catalog);
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

TEST_F(ServerTest, AStalePageIsToldWhoPushedWhat) {
  ScriptedRobot io("io", kDomain, catalog);
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

TEST_F(ServerTest, SwapPrintsEachStepAndProgramsRemembersThem) {
  ScriptedRobot io("io", kDomain, catalog), ganymede("ganymede", kDomain, catalog);
  wait_for_robots(2);
  const std::string monitor_option =
      " --monitor http://" + host() + " --token-file " + (folder / "operator.token").string() + " ";
  const std::string swap = GALILEAN_SWAP + monitor_option;
  const auto swapped =
      run(swap + (folder / "good.bhdl").string() + " --team --canary io --probation 300ms");
  EXPECT_EQ(swapped.exit_code, 0) << swapped.output;
  EXPECT_THAT(swapped.output, HasSubstr("check   done\n"));
  EXPECT_THAT(swapped.output, HasSubstr("canary  done  io ran it for 0.3 s\n"));
  EXPECT_THAT(swapped.output, HasSubstr("rest    done\n"));
  EXPECT_EQ(ganymede.running_hash(), io.running_hash());
  const auto first_hash = io.running_hash();

  write("other.bhdl", "states:\n  state:\n    name: \"wait\"\n  end\nend\n");
  const auto other = run(swap + (folder / "other.bhdl").string() + " --robot io");
  EXPECT_EQ(other.exit_code, 0) << other.output;
  EXPECT_EQ(run(swap + (folder / "broken.bhdl").string() + " --team").exit_code, 1);

  const std::string programs = GALILEAN_PROGRAMS + monitor_option;
  const auto list = run(programs + "list").output;
  EXPECT_EQ(std::ranges::count(list, '\n'), 2) << list;
  EXPECT_EQ(run(programs + "show " + first_hash.substr(0, 10)).output, kProgram);
  const auto diff =
      run(programs + "diff " + first_hash.substr(0, 10) + " " + io.running_hash().substr(0, 10) +
          " --catalog " + (folder / "catalog.json").string());
  EXPECT_EQ(diff.exit_code, 1) << diff.output;
  EXPECT_THAT(diff.output, HasSubstr("wait"));
  EXPECT_EQ(run(programs + "restore " + first_hash + " --robot io").exit_code, 0);
  EXPECT_EQ(io.running_hash(), first_hash);
  EXPECT_EQ(run(programs + "show 0123").exit_code, 2);
}

TEST_F(ServerTest, SwapWithoutAMonitorThereSaysSoInOneLine) {
  const auto alone = run(std::string(GALILEAN_SWAP) + " --monitor http://127.0.0.1:1 --team " +
                         (folder / "good.bhdl").string());
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.output, HasSubstr("no monitor answers at http://127.0.0.1:1"));
  EXPECT_EQ(std::ranges::count(alone.output, '\n'), 1);
}

TEST_F(ServerTest, HoldStopsTheRobotsThatAreNamed) {
  ScriptedRobot io("io", kDomain, catalog), ganymede("ganymede", kDomain, catalog);
  wait_for_robots(2);
  EXPECT_EQ(post("/api/command", {{"kind", "hold"}, {"targets", {"io"}}}).status, 200U);
  EXPECT_TRUE(becomes_true([&] { return io.held(); }));
  EXPECT_FALSE(ganymede.held());
  EXPECT_EQ(post("/api/command", {{"kind", "resume"}}).status, 200U);
  EXPECT_TRUE(becomes_true([&] { return !io.held(); }));
}

TEST_F(ServerTest, AFoxgloveClientReadsStatesEventsAndCallsServices) {
  ScriptedRobot io("io", kDomain, catalog);
  wait_for_robots(1);
  Socket socket(host(), monitor->port(), {},
                "/ws?token=" + read_token(folder / "operator.token").value());
  EXPECT_EQ(socket.response[http::field::sec_websocket_protocol], "foxglove.websocket.v1");
  const auto services = socket.read_op("advertiseServices")["services"];
  ASSERT_EQ(services.size(), 5U);
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

TEST_F(ServerTest, ARobotThatEndsStaysAndIsSilent) {
  {
    ScriptedRobot io("io", kDomain, catalog);
    wait_for_robots(1);
  }
  EXPECT_TRUE(becomes_true(
      [&] { return get("/api/status").as_json()["robots"][0]["silent"].get<bool>(); }));
  EXPECT_EQ(get("/api/team").as_json()["robots"][0]["state"], "start");
}

TEST_F(ServerTest, SwapWithoutAMonitorPrintsEachRobotsAnswer) {
  ScriptedRobot io("io", kDomain, catalog), ganymede("ganymede", kDomain, catalog);
  wait_for_robots(2);
  const std::string swap =
      std::string(GALILEAN_SWAP) + " --direct --domain " + std::to_string(kDomain) + " ";
  const auto swapped = run(swap + (folder / "good.bhdl").string() + " --team --json");
  EXPECT_EQ(swapped.exit_code, 0) << swapped.output;
  const auto answers = json::parse(swapped.output)["replies"];
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0]["status"], "running");
  EXPECT_EQ(io.running_hash(), json::parse(swapped.output)["hash"]);
  std::cout << "swap answered after " << answers[0]["latency_ms"] << " and "
            << answers[1]["latency_ms"] << " ms\n";
  EXPECT_TRUE(becomes_true([&] { return get("/api/pushes").as_json()["pushes"].size() == 1; }))
      << "the monitor remembers what others push";

  const auto broken = run(swap + (folder / "broken.bhdl").string() + " --team");
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_THAT(broken.output, HasSubstr("broken.bhdl:3:5: error: "));
  EXPECT_THAT(broken.output, HasSubstr("nothing was pushed"));
  const auto unknown = run(swap + (folder / "good.bhdl").string() + " --robot europa");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.output, HasSubstr("heard are ganymede, io"));
}

TEST_F(ServerTest, SwapWithoutARobotSaysSoInOneLine) {
  const auto alone = run(std::string(GALILEAN_SWAP) + " --direct --domain 230 --team " +
                         (folder / "good.bhdl").string());
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_EQ(std::ranges::count(alone.output, '\n'), 1);
}

TEST_F(ServerTest, APortThatIsTakenOrABadAddressIsOneLineAndExitCode2) {
  const std::string start = std::string(GALILEAN_MONITOR) + " --domain " + std::to_string(kDomain) +
                            " --data " + (folder / "second").string() + " --listen ";
  for (const auto& where : {host(), std::string("203.0.113.1:8080"), std::string("nowhere:1"),
                            std::string("127.0.0.1:99999")}) {
    const auto ended = run(start + where);
    EXPECT_EQ(ended.exit_code, 2) << where << ": " << ended.output;
    EXPECT_LE(std::ranges::count(ended.output, '\n'), 2) << ended.output;
  }
  EXPECT_EQ(run(start + "127.0.0.1:0 --domain 999").exit_code, 2);
}

}  // namespace
}  // namespace galilean::monitor
