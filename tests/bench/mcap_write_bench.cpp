// SPDX-License-Identifier: BSD-3-Clause
// Writes a recording beside plain zstd of the same bytes at the same level, and tells what a large
// recording holds.
#include <benchmark/benchmark.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/mcap_writer.h"

namespace galilean::mcap {
namespace {

constexpr std::size_t kMessageBytes = 300, kMessages = 200'000, kChunkBytes = std::size_t{1} << 20;
constexpr std::uint64_t kStep_ns = 1'000'000;

/// Takes bytes, and counts them.
class CountingSink final : public ByteSink {
 public:
  Result<void> write(std::span<const std::uint8_t> bytes) override {
    bytes_ += bytes.size();
    return {};
  }
  std::size_t bytes_ = 0;
};

/// Messages like a robot's state: names that stay, and some numbers that change with each.
Bytes telemetry() {
  Bytes bytes(kMessageBytes * kMessages);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < kMessages; ++i) {
    auto* message = bytes.data() + i * kMessageBytes;
    for (std::size_t at = 0; at < kMessageBytes; ++at)
      message[at] = static_cast<std::uint8_t>("office_cleanup.bhdl wander "[at % 27]);
    for (std::size_t at = 100; at < 180; ++at) message[at] = static_cast<std::uint8_t>(random());
  }
  return bytes;
}

/// Keeps all bytes.
class KeepingSink final : public ByteSink {
 public:
  Result<void> write(std::span<const std::uint8_t> bytes) override {
    kept_.insert(kept_.end(), bytes.begin(), bytes.end());
    return {};
  }
  Bytes kept_;
};

/// Writes all messages to a recording.
void record_all(const Bytes& bytes, Compression compression, ByteSink& sink) {
  Writer writer(sink, {.chunk_bytes = kChunkBytes, .compression = compression});
  (void)writer.begin();
  const auto channel = writer.add_channel({.topic = "/io/state", .message_encoding = "cdr"});
  for (std::size_t i = 0; i < kMessages; ++i) {
    const auto now_ns = (i + 1) * kStep_ns;
    (void)writer.write(Message{channel, static_cast<std::uint32_t>(i), now_ns, now_ns,
                               ByteView(bytes).subspan(i * kMessageBytes, kMessageBytes)});
  }
  (void)writer.end();
}

/// The same, to a recording that nobody keeps.
void record_all(const Bytes& bytes, Compression compression) {
  CountingSink sink;
  record_all(bytes, compression, sink);
  benchmark::DoNotOptimize(sink.bytes_);
}

void write_recording(benchmark::State& state) {
  const Bytes bytes = telemetry();
  for (auto _ : state) record_all(bytes, static_cast<Compression>(state.range(0)));
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size()) *
                          static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(write_recording)
    ->ArgName("compression")
    ->Arg(static_cast<int>(Compression::kFast))
    ->Arg(static_cast<int>(Compression::kLz4))
    ->Arg(static_cast<int>(Compression::kNone))
    ->Unit(benchmark::kMillisecond);

/// Compression alone, in pieces as large as a recording's chunks.
class PlainZstd1 {
 public:
  void compress_all(const Bytes& bytes) {
    for (std::size_t at = 0; at < bytes.size(); at += kChunkBytes)
      benchmark::DoNotOptimize(ZSTD_compressCCtx(context_.get(), frame_.data(), frame_.size(),
                                                 bytes.data() + at,
                                                 std::min(kChunkBytes, bytes.size() - at), 1));
  }

 private:
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context_{ZSTD_createCCtx(), ZSTD_freeCCtx};
  Bytes frame_ = Bytes(ZSTD_compressBound(kChunkBytes));
};

template <class Action>
double seconds_of(const Action& action) {
  const auto began = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// All take turns, so that what else the machine does slows all. The figure is the ratio to the
/// time that zstd takes for the same recording, written without compression; at least 0.7 is
/// wanted. Its messages alone, without the head of each, are what nobody could read again.
void write_beside_plain_zstd_1(benchmark::State& state) {
  const Bytes bytes = telemetry();
  KeepingSink uncompressed;
  record_all(bytes, Compression::kNone, uncompressed);
  PlainZstd1 zstd;
  double recording_s = 0, zstd_s = 0, messages_s = 0;
  for (auto _ : state) {
    recording_s += seconds_of([&] { record_all(bytes, Compression::kFast); });
    zstd_s += seconds_of([&] { zstd.compress_all(uncompressed.kept_); });
    messages_s += seconds_of([&] { zstd.compress_all(bytes); });
  }
  const double megabytes =
      static_cast<double>(bytes.size()) * static_cast<double>(state.iterations()) * 1e-6;
  state.counters["of_zstd"] = zstd_s / recording_s;
  state.counters["of_zstd_of_messages_alone"] = messages_s / recording_s;
  state.counters["recording_MB_per_s"] = megabytes / recording_s;
}
BENCHMARK(write_beside_plain_zstd_1)->Unit(benchmark::kMillisecond);

/// A file that is as long as `bytes` and whole as far as nobody reads its messages: what chunks
/// hold is a hole, which takes no room on the disk.
class HollowFile {
 public:
  explicit HollowFile(std::uint64_t bytes) {
    descriptor_ = mkstemp(path_.data());
    if (descriptor_ < 0) throw std::runtime_error("cannot make " + path_);
    add(ByteView(kMagic));
    append_and_add(Header{"ros2", "bench"});
    append_and_add(Channel{.id = 1, .topic = "/t", .message_encoding = "cdr", .metadata = {}});
    while (at_ < bytes) add_chunk();
    append_and_add(DataEnd{});
    add_summary();
  }
  ~HollowFile() {
    close(descriptor_);
    unlink(path_.c_str());
  }
  HollowFile(const HollowFile&) = delete;
  HollowFile& operator=(const HollowFile&) = delete;
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  void add(ByteView bytes) {
    if (pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at_)) !=
        static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("cannot write " + path_);
    at_ += bytes.size();
  }
  template <class Record>
  void append_and_add(const Record& record) {
    Bytes bytes;
    append(bytes, record);
    add(bytes);
  }
  void add_chunk() {
    static const Bytes content(kChunkBytes);
    Bytes bytes;
    const auto now_ns = 1 + chunks_.size() * 1'000'000'000;
    append(bytes, Chunk{.start_ns = now_ns,
                        .end_ns = now_ns,
                        .uncompressed_size = content.size(),
                        .compression = "",
                        .records = content});
    ChunkIndex index{.start_ns = now_ns,
                     .end_ns = now_ns,
                     .offset = at_,
                     .length = bytes.size(),
                     .compressed_size = content.size(),
                     .uncompressed_size = content.size()};
    const auto head = bytes.size() - content.size();
    add(ByteView(bytes).first(head));
    at_ += content.size();
    MessageIndex messages{.channel_id = 1, .entries = {}};
    for (std::uint64_t i = 0; i < 100; ++i) messages.entries.push_back({now_ns, i * 1000});
    index.message_index_offsets[1] = at_;
    const auto before = at_;
    append_and_add(messages);
    index.message_index_length = at_ - before;
    chunks_.push_back(std::move(index));
  }
  void add_summary() {
    Statistics statistics{.messages = 100 * chunks_.size(),
                          .channels = 1,
                          .chunks = static_cast<std::uint32_t>(chunks_.size()),
                          .start_ns = 1,
                          .end_ns = chunks_.back().end_ns};
    statistics.channel_messages[1] = statistics.messages;
    const auto start = at_;
    append_and_add(Channel{.id = 1, .topic = "/t", .message_encoding = "cdr", .metadata = {}});
    append_and_add(statistics);
    for (const auto& index : chunks_) append_and_add(index);
    append_and_add(Footer{start, 0, 0});
    add(ByteView(kMagic));
  }

  std::string path_ = "/tmp/galilean_hollow_XXXXXX";
  int descriptor_ = -1;
  std::uint64_t at_ = 0;
  std::vector<ChunkIndex> chunks_;
};

/// What `galilean log info` takes of a file of 4 GB that has a summary.
void tell_of_4_gigabytes(benchmark::State& state) {
  const HollowFile file(4'000'000'000);
  for (auto _ : state) {
    const auto source = FileSource::open(file.path());
    const auto summary = summarize(source.value());
    if (!summary || summary.value().recovered() || summary.value().checked)
      return state.SkipWithError("not told by its summary");
  }
  state.counters["of_100_ms"] =
      benchmark::Counter(0.1 * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(tell_of_4_gigabytes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace galilean::mcap
