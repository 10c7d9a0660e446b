// SPDX-License-Identifier: BSD-3-Clause
// Opens a WebSocket at /ws and sends random bytes as its frames, and then no more. Whatever comes,
// the server answers in frames of its own that are whole, not masked and, where they are text,
// JSON, and closes the connection in the end.
#include <nlohmann/json.hpp>
#include <string>

#include "core/wire/messages.h"
#include "tests/fuzz/served_connection.h"

namespace {

using namespace galilean::monitor;
using galilean::bhdl::must;

constexpr std::string_view kUpgrade =
    "GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Protocol: foxglove.websocket.v1\r\nAuthorization: Bearer operator\r\n\r\n";

/// What the server sent, frame by frame.
class FrameReader {
 public:
  explicit FrameReader(std::string_view bytes) : rest_(bytes) {}

  /// Looks at the next frame. Returns false if there is no whole one: the last may be cut off,
  /// because its client was gone.
  bool next() {
    if (rest_.size() < 2) return false;
    const std::uint8_t first = byte(0), second = byte(1);
    const std::uint8_t opcode = first & 0x0f;
    must((first & 0x70) == 0, "no extension was agreed on");
    must((second & 0x80) == 0, "a server does not mask");
    must(opcode <= 2 || (opcode >= 8 && opcode <= 10), "an opcode is known");
    const std::size_t head_bytes = second < 126 ? 2 : second == 126 ? 4 : 10;
    if (rest_.size() < head_bytes) return false;
    std::uint64_t size = second;
    if (head_bytes > 2) size = 0;
    for (std::size_t i = 2; i < head_bytes; ++i) size = size << 8 | byte(i);
    must(opcode < 8 || ((first & 0x80) != 0 && size <= 125), "a control frame is short and whole");
    if (rest_.size() - head_bytes < size) return false;
    const auto payload = rest_.substr(head_bytes, static_cast<std::size_t>(size));
    if (first == 0x81) must(nlohmann::json::accept(payload), "what the server says is JSON");
    rest_.remove_prefix(head_bytes + payload.size());
    return true;
  }

 private:
  [[nodiscard]] std::uint8_t byte(std::size_t at) const {
    return static_cast<std::uint8_t>(rest_[at]);
  }

  std::string_view rest_;
};

/// Gives the hub something to subscribe to and to call.
void fill(galilean::monitor::foxglove::Hub& hub) {
  using galilean::wire::Delivery;
  static const Channel channel{
      1, "rt/io/state",
      galilean::wire::find_schema_by_ros_type(galilean::msg::RobotState::kRosType),
      Delivery::kState};
  hub.add_channel(channel);
  hub.send({channel, 1, 1, std::make_shared<const std::vector<std::uint8_t>>(64)});
  hub.add_service(
      {"/galilean/hold", "galilean/Hold", nlohmann::json::object(), nlohmann::json::object()},
      [](const nlohmann::json& request, const foxglove::Hub::Answer& answer) { answer(request); });
  hub.send_parameters({{"/io.held", false}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static FuzzedServer server([](const HttpRequest&, const Respond& respond) {
    respond(problem(404, "The first request opens the WebSocket."));
  });
  static const bool is_filled = (fill(server.hub), true);
  must(is_filled, "the hub has something to tell");
  const auto answer = server.exchange(kUpgrade, {reinterpret_cast<const char*>(data), size});
  must(answer.starts_with("HTTP/1.1 101 "), "the WebSocket opens");
  FrameReader frames(std::string_view(answer).substr(answer.find("\r\n\r\n") + 4));
  while (frames.next()) {
  }
  const auto counts = server.hub.counts();
  must(counts.clients == 0 && counts.subscriptions == 0, "nothing is left of a client");
  return 0;
}
