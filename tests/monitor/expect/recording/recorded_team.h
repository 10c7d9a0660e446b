// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/ros_time.h"
#include "core/wire/schemas.h"
#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/mcap_writer.h"
#include "tests/monitor/expect/recording/cdr_text.h"

namespace galilean::expect {

/// Keeps a file in memory.
class MemorySink final : public mcap::ByteSink {
 public:
  Result<void> write(mcap::ByteView bytes) override {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return {};
  }
  mcap::Bytes bytes_;
};

/// A recording of robots that send their states and variables ten times a second.
class RecordedTeam {
 public:
  static constexpr std::uint64_t kBegin_ns = 1'700'000'000'000'000'000;

  RecordedTeam() : writer_(sink_, {.chunk_span = from_seconds(1)}) { (void)writer_.begin(); }

  template <class Message>
  void send(double s, const std::string& topic, const Message& message) {
    const auto at_ns = kBegin_ns + static_cast<std::uint64_t>(s * 1e9);
    const auto bytes = cdr(message);
    (void)writer_.write({channel(topic, Message::kRosType), ++sequence_[topic], at_ns, at_ns,
                         mcap::ByteView(bytes)});
  }
  [[nodiscard]] mcap::Writer& writer() noexcept { return writer_; }
  /// Closes the file. Returns its bytes.
  [[nodiscard]] mcap::Bytes& end() {
    (void)writer_.end();
    return sink_.bytes_;
  }
  /// Returns the bytes so far.
  [[nodiscard]] const mcap::Bytes& bytes() const noexcept { return sink_.bytes_; }
  [[nodiscard]] std::uint64_t messages() const { return writer_.statistics().messages; }

 private:
  std::uint16_t channel(const std::string& topic, const std::string& type) {
    auto known = channels_.find(topic);
    if (known != channels_.end()) return known->second;
    const auto* schema = wire::find_schema_by_ros_type(type);
    const auto id = writer_.add_schema(type, "ros2idl", std::string(schema->idl));
    return channels_[topic] =
               writer_.add_channel({.schema_id = id, .topic = topic, .message_encoding = "cdr"});
  }

  MemorySink sink_;
  mcap::Writer writer_;
  std::map<std::string, std::uint16_t> channels_;
  std::map<std::string, std::uint32_t> sequence_;
};

/// Changes a byte of the chunk that has messages of that time.
inline void damage_chunk_at(double s, mcap::Bytes& bytes) {
  const auto summary = mcap::summarize(mcap::MemorySource(bytes));
  const auto at_ns = RecordedTeam::kBegin_ns + static_cast<std::uint64_t>(s * 1e9);
  for (const auto& block : summary.value().blocks)
    if (block.start_ns <= at_ns && at_ns <= block.end_ns)
      bytes[block.offset + block.bytes - 1] ^= 0x55;
}

}  // namespace galilean::expect
