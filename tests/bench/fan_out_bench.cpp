// SPDX-License-Identifier: BSD-3-Clause
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/read.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "core/wire/messages.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/http/websocket_session.h"
#include "tests/bench/websocket_crowd.h"

namespace {

using namespace galilean;
using namespace galilean::monitor;
using boost::asio::ip::tcp;

constexpr std::size_t kClients = 100, kMessage_bytes = 1024;
constexpr std::uint64_t kUnderWay = 1000;  ///< messages that some client has not received yet
constexpr auto kWarmUp = std::chrono::seconds(1), kMeasured = std::chrono::seconds(4);

/// The monitor's WebSocket server with one channel of events. A call of its service publishes.
class EchoServer {
 public:
  explicit EchoServer(std::uint16_t port)
      : acceptor_(io_, tcp::endpoint(boost::asio::ip::address_v4::loopback(), port)) {
    const char* type = msg::Transition::kRosType;
    channel_ = {1, "rt/bench", wire::find_schema_by_ros_type(type), wire::delivery_of(type)};
    hub_.add_channel(channel_);
    hub_.add_service({"/publish", "bench/Publish", {}, {}},
                     [this](const nlohmann::json&, const foxglove::Hub::Answer&) {
                       hub_.send({channel_, 0, 0, payload_});
                     });
    accept();
  }
  void run() { io_.run(); }

 private:
  void accept() {
    acceptor_.async_accept([this](boost::system::error_code, tcp::socket socket) {
      boost::beast::flat_buffer buffer;
      boost::beast::http::request<boost::beast::http::string_body> upgrade;
      boost::beast::http::read(socket, buffer, upgrade);
      serve_websocket(std::move(socket), upgrade, hub_, rounds_, Right::kOperate, {});
      accept();
    });
  }

  foxglove::Hub hub_{"bench", nullptr};
  boost::asio::io_context io_{1};
  SendRounds rounds_{io_};
  tcp::acceptor acceptor_;
  Channel channel_;
  Payload payload_ = std::make_shared<const std::vector<std::uint8_t>>(kMessage_bytes);
};

pid_t start_server(std::uint16_t port) {
  const pid_t child = fork();
  if (child != 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  EchoServer(port).run();
  std::_Exit(0);
}

std::unique_ptr<bench::WebSocketCrowd> connect_patiently(std::uint16_t port,
                                                         const char* subprotocol) {
  for (int attempt = 0;; ++attempt) try {
      return std::make_unique<bench::WebSocketCrowd>(port, "/", subprotocol, kClients);
    } catch (const std::runtime_error&) {
      if (attempt == 200) throw;
      usleep(10'000);
    }
}

/// Lets one client publish as fast as the slowest client receives. Returns the messages that arrive
/// in a second.
double messages_a_second(bench::WebSocketCrowd& crowd, const std::function<void()>& publish) {
  using Clock = bench::WebSocketCrowd::Clock;
  std::vector<std::uint64_t> got(kClients);
  std::uint64_t published = 0, counted_from = 0;
  const auto total = [&] {
    std::uint64_t sum = 0;
    for (const auto each : got) sum += each;
    return sum;
  };
  const auto began = Clock::now();
  auto measured_from = began;
  for (auto now = began; now < began + kWarmUp + kMeasured; now = Clock::now()) {
    if (measured_from == began && now > began + kWarmUp) {
      measured_from = now;
      counted_from = total();
    }
    for (; published - *std::ranges::min_element(got) < kUnderWay; ++published) publish();
    crowd.read(std::chrono::milliseconds(100), [&](const auto& frame) {
      if (frame.size >= kMessage_bytes && frame.size < 2 * kMessage_bytes) ++got[frame.client];
    });
  }
  const std::chrono::duration<double> measured = Clock::now() - measured_from;
  return static_cast<double>(total() - counted_from) / measured.count();
}

double of_chat(std::uint16_t port) {
  const auto connected = connect_patiently(port, "");
  auto& crowd = *connected;
  const std::string message(kMessage_bytes, 'x');
  return messages_a_second(crowd, [&] { crowd.send_text(0, message); });
}

double of_hub(std::uint16_t port) {
  const pid_t server = start_server(port);
  const auto connected = connect_patiently(port, "foxglove.websocket.v1");
  auto& crowd = *connected;
  for (std::size_t i = 0; i < kClients; ++i)
    crowd.send_text(i, R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})");
  // The service call has as many bytes: opcode, service, call, and the encoding with its length.
  std::string call{2, 1, 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, 0};
  call += "json\"" + std::string(kMessage_bytes - call.size() - 6, 'x') + '"';
  const double result = messages_a_second(crowd, [&] { crowd.send_binary(0, call); });
  kill(server, SIGKILL);
  waitpid(server, nullptr, 0);
  return result;
}

}  // namespace

/// fan_out_bench PORT measures what one client publishes to 100 clients of the monitor's server, 1
/// KB a message. fan_out_bench PORT chat measures the same with Beast's chat-multi, which must
/// listen there already.
int main(int count, char** arguments) try {
  const auto port = static_cast<std::uint16_t>(count > 1 ? std::atoi(arguments[1]) : 0);
  std::printf("%.0f\n", count > 2 ? of_chat(port) : of_hub(port));
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "fan_out_bench: %s\n", error.what());
  return EXIT_FAILURE;
}
