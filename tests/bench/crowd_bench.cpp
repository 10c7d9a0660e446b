// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "tests/bench/websocket_crowd.h"

namespace {

using galilean::bench::WebSocketCrowd;
constexpr std::uint8_t kMessageData = 1;

std::int64_t wall_clock_ns() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

std::string subscription(int count, char** channel_ids) {
  std::string list;
  for (int i = 0; i < count; ++i)
    list += (i ? "," : "") + std::string("{\"id\":") + std::to_string(i) +
            ",\"channelId\":" + channel_ids[i] + "}";
  return "{\"op\":\"subscribe\",\"subscriptions\":[" + list + "]}";
}

/// How late messages came after the monitor had received them [ms].
struct Lateness {
  std::vector<float> all_ms = {};

  void note(const WebSocketCrowd::Frame& frame) {
    constexpr std::size_t kStampAt = 5;
    if (frame.begin.size() < kStampAt + 8 || frame.begin[0] != kMessageData) return;
    std::int64_t received_ns = 0;
    std::memcpy(&received_ns, &frame.begin[kStampAt], sizeof received_ns);
    const auto late_ms = static_cast<float>(wall_clock_ns() - received_ns) * 1e-6F;
    all_ms.push_back(late_ms);
  }
};

}  // namespace

/// crowd_bench PORT CLIENTS[:STALLED] SECONDS CHANNEL… lets this many clients of a monitor
/// subscribe to the channels. So many of them stop reading at once. It prints as JSON how many
/// messages the others got, and how late.
int main(int count, char** arguments) try {
  if (count < 5) throw std::runtime_error("PORT CLIENTS[:STALLED] SECONDS CHANNEL… are missing");
  const char* const colon = std::strchr(arguments[2], ':');
  const auto stalled = static_cast<std::size_t>(colon ? std::atoi(colon + 1) : 0);
  WebSocketCrowd crowd(static_cast<std::uint16_t>(std::atoi(arguments[1])), "/ws",
                       "foxglove.websocket.v1", static_cast<std::size_t>(std::atoi(arguments[2])));
  const auto subscribe = subscription(count - 4, arguments + 4);
  for (std::size_t i = 0; i < crowd.size(); ++i) crowd.send_text(i, subscribe);
  for (std::size_t i = 0; i < std::min(stalled, crowd.size()); ++i) crowd.stall(i);

  // Messages that are kept for late subscribers do not count.
  const auto settled = WebSocketCrowd::Clock::now() + std::chrono::seconds(1);
  while (WebSocketCrowd::Clock::now() < settled)
    crowd.read(std::chrono::milliseconds(10), [](const auto&) {});
  Lateness late;
  const auto end = WebSocketCrowd::Clock::now() + std::chrono::seconds(std::atoi(arguments[3]));
  while (WebSocketCrowd::Clock::now() < end)
    crowd.read(std::chrono::milliseconds(10), [&](const auto& frame) { late.note(frame); });

  std::ranges::sort(late.all_ms);
  if (late.all_ms.empty()) throw std::runtime_error("no message came");
  std::printf("{\"messages\":%zu,\"median_ms\":%.2f,\"p99_ms\":%.2f,\"worst_ms\":%.2f}\n",
              late.all_ms.size(), late.all_ms[late.all_ms.size() / 2],
              late.all_ms[late.all_ms.size() * 99 / 100], late.all_ms.back());
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "crowd_bench: %s\n", error.what());
  return EXIT_FAILURE;
}
