// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/logs/writing/sample_recording.h"

#include <random>
#include <string>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/message_reader.h"

namespace galilean::logs {
namespace {

constexpr std::uint64_t kBegin_ns = 1'700'000'000'000'000'000;
constexpr std::uint64_t kStep_ns = 20'000'000;  // how often a recorder looks at its chunk, at least
constexpr std::size_t kSteps = 1000, kTopics = 3;

Result<void> write_extras(mcap::Writer& writer) {
  const mcap::Bytes text(3000, 'x');
  return writer.write(mcap::Attachment{.log_ns = kBegin_ns,
                                       .create_ns = kBegin_ns,
                                       .name = "3f2a91c0/talk.bhdl",
                                       .media_type = "text/plain",
                                       .data_bytes = text.size()},
                      mcap::MemorySource(text));
}

}  // namespace

std::vector<Sample> random_samples(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Sample> samples;
  std::uint32_t sequences[kTopics] = {};
  for (std::size_t step = 0; step < kSteps; ++step) {
    if (random() % 3 != 0) continue;
    const auto topic = random() % kTopics;
    Sample sample{.channel = static_cast<std::uint16_t>(1 + topic),
                  .sequence = ++sequences[topic],
                  .log_ns = kBegin_ns + step * kStep_ns,
                  .data = mcap::Bytes(random() % 60)};
    for (auto& byte : sample.data) byte = static_cast<std::uint8_t>(random() % 8);
    samples.push_back(std::move(sample));
  }
  return samples;
}

Result<void> write_samples(const std::vector<Sample>& samples, mcap::ByteSink& sink,
                           mcap::Compression compression,
                           const std::function<void(std::size_t)>& accepted) {
  mcap::Writer writer(sink, {.compression = compression});
  auto done = writer.begin();
  if (done) done = writer.write(mcap::Metadata{"galilean", {{"version", "1"}, {"seed", "7"}}});
  const auto schema = writer.add_schema("a/msg/A", "ros2msg", "uint8[] data\n");
  for (std::size_t topic = 0; topic < kTopics; ++topic)
    (void)writer.add_channel({.schema_id = schema,
                              .topic = "/topic_" + std::to_string(topic),
                              .message_encoding = "cdr"});
  std::size_t count = 0;
  for (std::size_t step = 0; step < kSteps && done; ++step) {
    const auto now_ns = kBegin_ns + step * kStep_ns;
    done = writer.close_chunk_if_due(now_ns);
    if (done && step == kSteps / 2) done = write_extras(writer);
    if (!done || count == samples.size() || samples[count].log_ns != now_ns) continue;
    const auto& sample = samples[count];
    done =
        writer.write(mcap::Message{sample.channel, sample.sequence, now_ns, now_ns, sample.data});
    if (done) accepted(++count);
  }
  return done ? writer.end() : done;
}

std::optional<std::vector<Sample>> read_samples(const mcap::ByteSource& source) {
  const auto summary = mcap::summarize(source, mcap::Depth::kAll);
  if (!summary || summary.value().recovered()) return std::nullopt;
  std::vector<Sample> samples;
  mcap::MessageReader reader(source, summary.value().blocks);
  while (const mcap::Message* message = reader.next()) {
    const auto& topic = summary.value().channels.at(message->channel_id).topic;
    const auto channel = static_cast<std::uint16_t>(1 + std::stoi(topic.substr(topic.size() - 1)));
    samples.push_back({channel, message->sequence, message->log_ns,
                       mcap::Bytes(message->data.begin(), message->data.end())});
  }
  return samples;
}

}  // namespace galilean::logs
