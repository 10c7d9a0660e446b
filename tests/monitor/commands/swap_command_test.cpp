// SPDX-License-Identifier: BSD-3-Clause
// `galilean swap` and `galilean programs`, against a monitor and without one.
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <csignal>
#include <thread>
#include <vector>

#include "monitor/front/process.h"
#include "tests/free_domain.h"
#include "tests/monitor/scripted_robot.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using SwapCommandTest = ServerFixture;

TEST_F(SwapCommandTest, SwapPrintsEachStepAndProgramsRemembersThem) {
  ScriptedRobot io("io", test_domain(), catalog), ganymede("ganymede", test_domain(), catalog);
  wait_for_robots(2);
  const std::string monitor_option =
      " --monitor http://" + host() + " --token-file " + (folder / "operator.token").string() + " ";
  const std::string swap = GALILEAN_SWAP + monitor_option;
  const auto swapped =
      run_command(swap + (folder / "good.bhdl").string() + " --team --canary io --probation 300ms");
  EXPECT_EQ(swapped.exit_code, 0) << swapped.output;
  EXPECT_THAT(swapped.output, HasSubstr("check   done\n"));
  EXPECT_THAT(swapped.output, HasSubstr("canary  done  io ran it for 0.3 s\n"));
  EXPECT_THAT(swapped.output, HasSubstr("rest    done\n"));
  EXPECT_EQ(ganymede.running_hash(), io.running_hash());
  const auto first_hash = io.running_hash();

  write("other.bhdl", "states:\n  state:\n    name: \"wait\"\n  end\nend\n");
  const auto other = run_command(swap + (folder / "other.bhdl").string() + " --robot io");
  EXPECT_EQ(other.exit_code, 0) << other.output;
  EXPECT_EQ(run_command(swap + (folder / "broken.bhdl").string() + " --team").exit_code, 1);

  write("typo.bhdl", "states:\n  state:\n    nmae: \"wait\"\n  end\nend\n");
  const auto typo = run_command(swap + (folder / "typo.bhdl").string() + " --team");
  EXPECT_EQ(typo.exit_code, 1);
  EXPECT_THAT(typo.output, HasSubstr("\n  hint: did you mean 'name'?\n"));

  const std::string programs = GALILEAN_PROGRAMS + monitor_option;
  const auto list = run_command(programs + "list").output;
  EXPECT_EQ(std::ranges::count(list, '\n'), 2) << list;
  EXPECT_EQ(run_command(programs + "show " + first_hash.substr(0, 10)).output, kProgram);
  const auto diff = run_command(programs + "diff " + first_hash.substr(0, 10) + " " +
                                io.running_hash().substr(0, 10) + " --catalog " +
                                (folder / "catalog.json").string());
  EXPECT_EQ(diff.exit_code, 1) << diff.output;
  EXPECT_THAT(diff.output, HasSubstr("wait"));
  EXPECT_EQ(run_command(programs + "restore " + first_hash + " --robot io").exit_code, 0);
  EXPECT_EQ(io.running_hash(), first_hash);
  EXPECT_EQ(run_command(programs + "show 0123").exit_code, 1);
}

TEST_F(SwapCommandTest, AnIncludeThatIsMissingHereIsNotTakenFromTheMonitorsPrograms) {
  ScriptedRobot io("io", test_domain(), catalog);
  wait_for_robots(1);
  ASSERT_TRUE(std::filesystem::exists(folder / "programs" / "parts.bhdl"));
  write("copy.bhdl", "include \"parts.bhdl\"\n");
  const auto path = (folder / "copy.bhdl").string();
  const std::string swap = std::string(GALILEAN_SWAP) + " --team " + path;
  const std::string through = swap + " --monitor http://" + host() + " --token-file " +
                              (folder / "operator.token").string();
  const std::string direct = swap + " --direct --domain " + std::to_string(test_domain());
  for (const auto& command : {through, direct}) {
    const auto refused = run_command(command);
    EXPECT_EQ(refused.exit_code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr(path + ":1:9: error: cannot read"));
    EXPECT_THAT(refused.output, HasSubstr("galilean swap: nothing was pushed\n"));
    const auto as_json = run_command(command + " --json");
    EXPECT_EQ(as_json.exit_code, 1);
    EXPECT_EQ(json::parse(as_json.output)["diagnostics"][0]["code"], "include/not-found");
  }
  EXPECT_EQ(io.running_hash(), "first");
}

TEST_F(SwapCommandTest, CtrlCCancelsWhatHasNotBegunAndTakesTheCanaryBack) {
  ScriptedRobot io("io", test_domain(), catalog), ganymede("ganymede", test_domain(), catalog);
  wait_for_robots(2);
  auto swap = front::Process::start(
      "swap",
      {GALILEAN_SWAP, "--monitor", "http://" + host(), "--token-file",
       (folder / "operator.token").string(), "--team", "--author", "balch", "--canary", "io",
       "--probation", "10min", (folder / "good.bhdl").string()},
      folder / "swap.log");
  ASSERT_TRUE(swap) << swap.error().message;
  ASSERT_TRUE(becomes_true([&] { return io.running_hash() != "first"; }));
  ASSERT_EQ(kill(swap.value().pid(), SIGINT), 0);
  ASSERT_TRUE(becomes_true([&] { return !swap.value().running(); }));
  EXPECT_EQ(swap.value().ending(), "exit code 1");
  EXPECT_THAT(front::last_lines(folder / "swap.log", 10),
              HasSubstr("canary  cancelled  cancelled by balch\n"));
  EXPECT_TRUE(becomes_true([&] { return io.running_hash() == "first"; }));
  EXPECT_EQ(ganymede.running_hash(), "first");
  EXPECT_EQ(get("/api/pushes").as_json()["pushes"][0]["state"], "cancelled");
}

TEST_F(SwapCommandTest, AnotherServerOnTheMonitorsPortIsNamedAsSuch) {
  boost::asio::io_context io;
  using boost::asio::ip::tcp;
  tcp::acceptor acceptor(io, {boost::asio::ip::address_v4::loopback(), 0});
  std::thread server([&] {
    auto socket = acceptor.accept();
    std::array<char, 4096> request{};
    socket.read_some(boost::asio::buffer(request));
    boost::asio::write(
        socket,
        boost::asio::buffer(std::string_view("HTTP/1.1 200 OK\r\nContent-Length: 5\r\n\r\nhello")));
  });
  const std::string url = "http://127.0.0.1:" + std::to_string(acceptor.local_endpoint().port());
  const auto list = run_command(std::string(GALILEAN_PROGRAMS) + " --monitor " + url + " list");
  server.join();
  EXPECT_EQ(list.exit_code, 1) << list.output;
  EXPECT_THAT(list.output, HasSubstr("is no monitor of Galilean"));
  EXPECT_EQ(std::ranges::count(list.output, '\n'), 1) << list.output;
}

TEST_F(SwapCommandTest, APushWhoseAnswerWasLostIsSentAgainWithTheSameId) {
  boost::asio::io_context io;
  using boost::asio::ip::tcp;
  tcp::acceptor acceptor(io, {boost::asio::ip::address_v4::loopback(), 0});
  std::vector<std::string> requests;
  std::thread monitor_that_restarts([&] {
    const std::string body = R"({"id":"1","state":"done","steps":[],"replies":[]})";
    const std::string done =
        "HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
    // The push, the same again, and the end of the lease.
    for (const auto& answer : {std::string(), done, done}) {
      auto socket = acceptor.accept();
      std::array<char, 8192> request{};
      const auto size = socket.read_some(boost::asio::buffer(request));
      requests.emplace_back(request.data(), size);
      if (!answer.empty()) boost::asio::write(socket, boost::asio::buffer(answer));
    }
  });
  const std::string url = "http://127.0.0.1:" + std::to_string(acceptor.local_endpoint().port());
  const auto swapped = run_command(std::string(GALILEAN_SWAP) + " --monitor " + url + " --team " +
                                   (folder / "good.bhdl").string());
  monitor_that_restarts.join();
  EXPECT_EQ(swapped.exit_code, 0) << swapped.output;
  const auto id_in = [](const std::string& request) {
    const auto body = json::parse(request.substr(request.find("\r\n\r\n") + 4), nullptr, false);
    return body.is_object() ? body.value("id", "") : std::string();
  };
  EXPECT_EQ(id_in(requests[0]).size(), 32U) << requests[0];
  EXPECT_EQ(id_in(requests[1]), id_in(requests[0]));
}

TEST_F(SwapCommandTest, SwapWithoutAMonitorThereSaysSoInOneLine) {
  const auto alone =
      run_command(std::string(GALILEAN_SWAP) + " --monitor http://127.0.0.1:1 --team " +
                  (folder / "good.bhdl").string());
  EXPECT_EQ(alone.exit_code, 1);
  EXPECT_THAT(alone.output, HasSubstr("no monitor answers at http://127.0.0.1:1"));
  EXPECT_EQ(std::ranges::count(alone.output, '\n'), 1);
}

TEST_F(SwapCommandTest, SwapWithoutAMonitorPrintsEachRobotsAnswer) {
  ScriptedRobot io("io", test_domain(), catalog), ganymede("ganymede", test_domain(), catalog);
  wait_for_robots(2);
  const std::string swap =
      std::string(GALILEAN_SWAP) + " --direct --domain " + std::to_string(test_domain()) + " ";
  const auto swapped = run_command(swap + (folder / "good.bhdl").string() + " --team --json");
  EXPECT_EQ(swapped.exit_code, 0) << swapped.output;
  const auto answers = json::parse(swapped.output)["replies"];
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0]["status"], "running");
  EXPECT_EQ(io.running_hash(), json::parse(swapped.output)["hash"]);
  std::cout << "swap answered after " << answers[0]["latency_ms"] << " and "
            << answers[1]["latency_ms"] << " ms\n";
  EXPECT_TRUE(becomes_true([&] { return get("/api/pushes").as_json()["pushes"].size() == 1; }))
      << "the monitor remembers what others push";

  const auto broken = run_command(swap + (folder / "broken.bhdl").string() + " --team");
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_THAT(broken.output, HasSubstr("broken.bhdl:3:5: error: "));
  EXPECT_THAT(broken.output, HasSubstr("nothing was pushed"));
  const auto unknown = run_command(swap + (folder / "good.bhdl").string() + " --robot europa");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.output, HasSubstr("these do: ganymede, io"));
}

TEST_F(SwapCommandTest, SwapWithoutARobotSaysSoInOneLine) {
  const auto alone =
      run_command(std::string(GALILEAN_SWAP) + " --direct --domain " +
                  std::to_string(free_domain()) + " --team " + (folder / "good.bhdl").string());
  EXPECT_EQ(alone.exit_code, 1);
  EXPECT_EQ(std::ranges::count(alone.output, '\n'), 1);
}

}  // namespace
}  // namespace galilean::monitor
