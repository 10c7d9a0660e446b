// SPDX-License-Identifier: BSD-3-Clause
// What a writer must remember until its recording ends, since the summary stands at the end: how
// fast its memory grows, and for how long a recorder that may have 100 MiB can record into one
// file.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <string>

#include "monitor/mcap/mcap_writer.h"

namespace galilean::mcap {
namespace {

constexpr int kHour_s = 3600;
constexpr std::size_t kMessageBytes = 100;
constexpr std::uint64_t kSecond_ns = 1'000'000'000;
constexpr double kWanted_bytes = 100 * 1024 * 1024;

/// Takes bytes, and keeps none.
class Nowhere final : public ByteSink {
 public:
  Result<void> write(std::span<const std::uint8_t>) override { return {}; }
};

double allocated_bytes() {
  const auto all = mallinfo2();
  return static_cast<double>(all.uordblks + all.hblkhd);
}

/// Writes an hour with a message of each channel in each second, which is when a chunk ends.
void remember_an_hour(benchmark::State& state) {
  const auto channels = static_cast<int>(state.range(0));
  const Bytes payload(kMessageBytes);
  double grown_bytes = 0;
  for (auto _ : state) {
    Nowhere sink;
    Writer writer(sink);
    (void)writer.begin();
    for (int i = 0; i < channels; ++i)
      (void)writer.add_channel({.topic = "/t" + std::to_string(i), .message_encoding = "cdr"});
    const auto write_second = [&](int second) {
      const auto now_ns = static_cast<std::uint64_t>(1 + second) * kSecond_ns;
      for (int i = 0; i < channels; ++i)
        (void)writer.write(Message{static_cast<std::uint16_t>(1 + i),
                                   static_cast<std::uint32_t>(second), now_ns, now_ns, payload});
    };
    write_second(0);
    write_second(1);
    const double before_bytes = allocated_bytes();
    for (int second = 2; second < kHour_s; ++second) write_second(second);
    grown_bytes = allocated_bytes() - before_bytes;
    (void)writer.end();
  }
  state.counters["MiB_an_hour"] = grown_bytes / (1024 * 1024);
  state.counters["hours_to_100_MiB"] = grown_bytes > 0 ? kWanted_bytes / grown_bytes : 0;
}
/// Three robots have some 40 channels, and thirty some 400.
BENCHMARK(remember_an_hour)
    ->ArgName("channels")
    ->Arg(40)
    ->Arg(400)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace galilean::mcap
