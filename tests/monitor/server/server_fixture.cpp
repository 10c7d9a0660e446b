// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/server/server_fixture.h"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <fstream>

#include "monitor/access/tokens.h"
#include "tests/free_domain.h"

namespace galilean::monitor {
namespace {
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
}  // namespace

int test_domain() {
  static const int kDomain = free_domain();
  return kDomain;
}

Ran run_command(const std::string& command) {
  Ran result;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> part;
  while (const auto size = fread(part.data(), 1, part.size(), pipe))
    result.output.append(part.data(), size);
  const int status = pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

void ServerFixture::SetUp() {
  std::filesystem::create_directories(folder / "programs");
  write("programs/main.bhdl", "include \"parts.bhdl\"\n");
  write("programs/parts.bhdl", kProgram);
  write("good.bhdl", kProgram);
  write("broken.bhdl", kBroken);
  MonitorOptions options;
  options.port = 0;
  options.domain = test_domain();
  options.data_folder = folder.path();
  options.library_folder = folder / "programs";
  options.catalog_file = folder / "catalog.json";
  write("catalog.json", catalog_to_json({}));
  change(options);
  auto made = Monitor::make(options);
  ASSERT_TRUE(made) << made.error().message;
  monitor = std::move(made).value();
  thread = std::thread([this] { monitor->run(); });
}

void ServerFixture::TearDown() {
  if (monitor) monitor->stop();
  if (thread.joinable()) thread.join();
  monitor.reset();
}

void ServerFixture::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder / name) << text;
}

HttpAnswer ServerFixture::request(http::verb verb, const std::string& target,
                                  const std::string& body, const Headers& headers) {
  asio::io_context io;
  asio::ip::tcp::socket socket(io);
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

HttpAnswer ServerFixture::get(const std::string& target) {
  return request(http::verb::get, target);
}

HttpAnswer ServerFixture::post(const std::string& target, const nlohmann::json& body) {
  return request(http::verb::post, target, body.dump(), bearer("operator.token"));
}

ServerFixture::Headers ServerFixture::bearer(const std::string& file) const {
  return {{"Authorization", "Bearer " + read_token(folder / file).value()}};
}

nlohmann::json ServerFixture::files(const char* text) {
  return nlohmann::json::array({{{"path", "pushed.bhdl"}, {"text", text}}});
}

bool ServerFixture::becomes_true(const std::function<bool()>& condition,
                                 std::chrono::seconds patience) {
  constexpr auto kPause = std::chrono::milliseconds(20);
  for (auto waited = kPause; waited <= patience; waited += kPause) {
    if (condition()) return true;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

void ServerFixture::wait_for_robots(std::size_t count) {
  ASSERT_TRUE(becomes_true([&] {
    const auto robots = get("/api/status").as_json()["robots"];
    return robots.size() == count && std::ranges::all_of(robots, [](const auto& robot) {
             return !robot["state"].template get<std::string>().empty();
           });
  }));
}

}  // namespace galilean::monitor
