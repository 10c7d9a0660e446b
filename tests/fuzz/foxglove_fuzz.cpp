// SPDX-License-Identifier: BSD-3-Clause
// Gives random messages to a client of the hub, as its socket does. An input that begins with a
// brace is a text message a line. Any other input is a row of messages: one byte that is 1 where it
// is text, two for the size, and the message. Each answer must be a frame whose head tells its
// size, a service call that is read must be the one that was written, and nothing must be left of
// a client that goes.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "tests/fuzz/input.h"

namespace {

using namespace galilean::monitor;
using galilean::bhdl::must;
using nlohmann::json;

using Bytes = std::span<const std::uint8_t>;

class NoLink final : public foxglove::Link {
 public:
  void flush() override {}
  void close(const std::string& reason) override {
    must(reason.size() <= 123, "a reason fits into a close frame");
  }
};

/// Returns the number of bytes that a frame's head says follow it, with Foxglove's part of the
/// head.
std::uint64_t told_size(Bytes head) {
  const std::size_t head_bytes = head[1] < 126 ? 2 : head[1] == 126 ? 4 : 10;
  must(head.size() >= head_bytes, "a head is whole");
  if (head_bytes == 2) return head[1] + head_bytes;
  std::uint64_t size = 0;
  for (const auto byte : head.subspan(2, head_bytes - 2)) size = size << 8 | byte;
  return size + head_bytes;
}

void check(const Frame& frame) {
  const auto head = frame.head_bytes();
  must(head.size() >= 2 && told_size(head) == frame.size(), "a head tells its frame's size");
  if (head[0] != 0x81) return;
  must(json::accept(frame.payload->begin(), frame.payload->end()), "what the hub says is JSON");
}

void put(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

void check_call(Bytes message) {
  ServiceCall call;
  if (!read_service_call(message, call)) return;
  std::vector<std::uint8_t> again{2};
  put(again, call.service_id);
  put(again, call.call_id);
  put(again, static_cast<std::uint32_t>(call.encoding.size()));
  again.insert(again.end(), call.encoding.begin(), call.encoding.end());
  again.insert(again.end(), call.request.begin(), call.request.end());
  must(std::ranges::equal(again, message), "what is read is what was written");
}

class FuzzedClient {
 public:
  FuzzedClient() {
    hub_.add_channel(channel_);
    hub_.send({channel_, 1, 1, std::make_shared<const std::vector<std::uint8_t>>(64)});
    hub_.add_service(
        {"/galilean/hold", "galilean/Hold", json::object(), json::object()},
        [](const json& request, const foxglove::Hub::Answer& answer) { answer(request); });
    hub_.on_set_parameter([](const foxglove::Parameter& wanted,
                             const foxglove::Hub::Answer& answer) { answer(wanted.value); });
    hub_.send_parameters({{"/io.held", false}, {"/io.program", "office"}});
    client_ = hub_.connect(link_, true);
  }

  void send(bool is_text, Bytes message) {
    if (is_text) {
      client_->receive_text({reinterpret_cast<const char*>(message.data()), message.size()});
    } else {
      check_call(message);
      client_->receive_binary(message);
    }
    hub_.send({channel_, 2, 2, std::make_shared<const std::vector<std::uint8_t>>(8)});
    hub_.send_parameters({{"/io.held", ++sent_ % 2 == 0}, {"/io.program", "office"}});
    hub_.send_graph({{{"/io/state", {std::to_string(sent_ % 2)}}}, {}, {}});
    constexpr std::size_t kAtOnce = 64;
    while (!client_->outbox().empty())
      for (const auto& frame : client_->outbox().take(kAtOnce)) check(frame);
  }

  void leave() {
    client_.reset();
    const auto counts = hub_.counts();
    must(counts.clients == 0 && counts.subscriptions == 0, "nothing is left of a client");
    must(!is_wanted_, "nobody wants the channel any more");
  }

 private:
  const Channel channel_{
      1, "rt/io/state",
      galilean::wire::find_schema_by_ros_type(galilean::msg::RobotState::kRosType),
      galilean::wire::Delivery::kState};
  bool is_wanted_ = false;
  unsigned sent_ = 0;
  NoLink link_;
  foxglove::Hub hub_{"monitor", [this](std::uint32_t channel_id, bool wanted) {
                       must(channel_id == 1 && wanted != is_wanted_, "demand changes each time");
                       is_wanted_ = wanted;
                     }};
  std::unique_ptr<foxglove::Hub::Client> client_;
};

void send_lines(FuzzedClient& client, Bytes input) {
  while (!input.empty()) {
    const auto end = std::ranges::find(input, std::uint8_t{'\n'});
    const auto size = static_cast<std::size_t>(end - input.begin());
    client.send(true, input.first(size));
    input = input.subspan(std::min(size + 1, input.size()));
  }
}

void send_row(FuzzedClient& client, Bytes input) {
  constexpr std::size_t kHeadBytes = 3;
  while (input.size() > kHeadBytes) {
    const bool is_text = input[0] == 1;
    const std::size_t most = static_cast<std::size_t>(input[1]) << 8 | input[2];
    input = input.subspan(kHeadBytes);
    const auto message = input.first(std::min(most, input.size()));
    client.send(is_text, message);
    input = input.subspan(message.size());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedClient client;
  const Bytes input(data, size);
  if (!input.empty() && input[0] == '{')
    send_lines(client, input);
  else
    send_row(client, input);
  client.leave();
  return 0;
}
