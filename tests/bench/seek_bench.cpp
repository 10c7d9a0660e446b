// SPDX-License-Identifier: BSD-3-Clause
// How long it takes from a seek in a recording of an hour until all is told that was so then. The
// file is on the disk, and as large as that of three robots with pictures.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <random>

#include "core/clock.h"
#include "monitor/mcap/mcap_writer.h"
#include "monitor/playback/seekable_player.h"

namespace galilean::monitor {
namespace {

constexpr int kHour_s = 3600;
constexpr int kStates = 30, kPictures = 3, kRare = 9;
constexpr double kWanted_ms = 200;  ///< of 99 seeks in a hundred
constexpr std::size_t kStateBytes = 300, kPictureBytes = 13'000;
constexpr std::uint64_t kStart_ns = 1'700'000'000'000'000'000;

/// Half random, as telemetry and pictures are to a compressor.
mcap::Bytes payload_of(std::size_t size, std::mt19937& random) {
  mcap::Bytes payload(size);
  for (std::size_t i = 0; i < size; i += 2) payload[i] = static_cast<std::uint8_t>(random());
  return payload;
}

/// Ten times a second each state, five times each picture; what is rare came once, at the start.
void write_hour(const std::string& path) {
  auto file = mcap::FileSink::create(path, true);
  mcap::Writer writer(file.value());
  std::mt19937 random(1);
  (void)writer.begin();
  for (int i = 0; i < kStates + kPictures + kRare; ++i)
    (void)writer.add_channel({.topic = "/t" + std::to_string(i), .message_encoding = "cdr"});
  const auto write = [&](int channel, std::uint64_t log_ns, std::size_t bytes) {
    const auto payload = payload_of(bytes, random);
    (void)writer.write(
        mcap::Message{static_cast<std::uint16_t>(1 + channel), 0, log_ns, log_ns, payload});
  };
  for (int i = 0; i < kRare; ++i) write(kStates + kPictures + i, kStart_ns, kStateBytes);
  for (int tick = 0; tick < 10 * kHour_s; ++tick) {
    const auto log_ns = kStart_ns + static_cast<std::uint64_t>(tick) * 100'000'000;
    for (int i = 0; i < kStates; ++i) write(i, log_ns, kStateBytes);
    if (tick % 2 == 0)
      for (int i = 0; i < kPictures; ++i) write(kStates + i, log_ns, kPictureBytes);
  }
  (void)writer.end();
}

std::vector<RecordedTopic> topics() {
  std::vector<RecordedTopic> all;
  for (int i = 0; i < kStates + kPictures + kRare; ++i) {
    const bool is_picture = i >= kStates && i < kStates + kPictures;
    all.push_back({.topic = "/t" + std::to_string(i),
                   .delivery = is_picture ? wire::Delivery::kStream : wire::Delivery::kState,
                   .channels = {static_cast<std::uint16_t>(1 + i)}});
  }
  return all;
}

void seek_in_an_hour(benchmark::State& state) {
  const auto path = std::filesystem::temp_directory_path() / "galilean_seek_bench.mcap";
  write_hour(path.string());
  {
    const auto file = mcap::FileSource::open(path.string());
    const auto summary = mcap::summarize(file.value(), mcap::Depth::kIndexes);
    const auto all = topics();
    const SteadyClock clock;
    SeekablePlayer player(file.value(), summary.value(), all, clock);
    player.pause(true);
    RecordingCursor::Channels wanted;
    for (const auto& topic : all) wanted.insert(topic.channels.begin(), topic.channels.end());
    player.want(wanted);
    std::mt19937_64 random(2);
    std::vector<double> took_ms;
    for (auto _ : state) {
      const auto at_ns = kStart_ns + random() % (std::uint64_t{kHour_s} * 1'000'000'000);
      const auto begin = std::chrono::steady_clock::now();
      player.seek(at_ns);
      for (; player.due(); player.take()) {
      }
      took_ms.push_back(
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
              .count());
    }
    std::ranges::sort(took_ms);
    state.counters["p50_ms"] = took_ms[took_ms.size() / 2];
    state.counters["p99_ms"] = took_ms[took_ms.size() * 99 / 100];
    state.counters["p99_of_wanted"] = took_ms[took_ms.size() * 99 / 100] / kWanted_ms;
    state.counters["max_ms"] = took_ms.back();
    state.counters["file_MB"] = static_cast<double>(summary.value().bytes) * 1e-6;
  }
  std::filesystem::remove(path);
}
BENCHMARK(seek_in_an_hour)->Iterations(500)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace galilean::monitor
