// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "monitor/mcap/crc32.h"
#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/message_reader.h"
#include "monitor/mcap/zstd.h"

namespace galilean::mcap {
namespace {

constexpr std::size_t kFileBytes = std::size_t{128} << 20;
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;
constexpr double kWanted_bytes_per_s = 500e6;  ///< of the messages, however they are compressed

Bytes payload_of(std::size_t size) {
  Bytes payload(size);
  std::uint32_t state = 1;
  for (auto& byte : payload)
    byte = static_cast<std::uint8_t>((state = state * 1664525 + 1013904223) >> 27);
  return payload;
}

void append_chunk(Bytes& file, const Bytes& payload, std::uint64_t& now_ns, bool compressed) {
  Chunk chunk{.start_ns = now_ns, .end_ns = 0};
  Bytes records;
  while (records.size() < kChunkBytes)
    append(records, Message{.channel_id = 1, .log_ns = now_ns += 1000, .data = payload});
  Compressor compressor(Compression::kFast);
  chunk.end_ns = now_ns;
  chunk.uncompressed_size = records.size();
  chunk.uncompressed_crc = crc32(records);
  chunk.compression = compressed ? "zstd" : "";
  chunk.records = compressed ? compressor.compress(records) : ByteView(records);
  append(file, chunk);
}

Bytes file_of(std::size_t message_bytes, bool compressed) {
  Bytes file(std::begin(kMagic), std::end(kMagic));
  append(file, Header{"bench", "bench"});
  append(file, Channel{.id = 1, .topic = "/t", .message_encoding = "cdr", .metadata = {}});
  const Bytes payload = payload_of(message_bytes);
  std::uint64_t now_ns = 1;
  for (std::size_t made = 0; made < kFileBytes; made += kChunkBytes)
    append_chunk(file, payload, now_ns, compressed);
  append(file, DataEnd{});
  append(file, Footer{});
  file.insert(file.end(), std::begin(kMagic), std::end(kMagic));
  return file;
}

/// Reads all messages in the order of log time, with their checksums compared.
void read_in_log_time_order(benchmark::State& state) {
  const Bytes file = file_of(static_cast<std::size_t>(state.range(0)), state.range(1) != 0);
  const MemorySource source(file);
  const Survey found = survey(source, {}, 0);
  std::uint64_t bytes = 0;
  for (auto _ : state) {
    MessageReader reader(source, found.blocks);
    while (const Message* message = reader.next()) bytes += message->data.size();
    if (!reader.damages().empty()) return state.SkipWithError("damaged");
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
  state.counters["of_wanted"] = benchmark::Counter(static_cast<double>(bytes) / kWanted_bytes_per_s,
                                                   benchmark::Counter::kIsRate);
}
BENCHMARK(read_in_log_time_order)
    ->ArgNames({"message_bytes", "zstd"})
    ->ArgsProduct({{100, 1000, 30000}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace galilean::mcap
