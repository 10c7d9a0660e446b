// SPDX-License-Identifier: BSD-3-Clause
// Reads random recordings: they are surveyed, all their messages are read in order, and each byte
// of them is looked at. The reader must give times that do not fall. Then it looks up what was so
// in the middle.
#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/message_reader.h"
#include "monitor/mcap/newest_messages.h"
#include "tests/fuzz/input.h"

namespace {

using namespace galilean::mcap;
using galilean::bhdl::must;

void read_all(const ByteSource& source, const Summary& summary, std::size_t memory_bytes) {
  MessageReader reader(source, summary.blocks, memory_bytes);
  std::uint64_t before_ns = 0;
  unsigned sum = 0;
  while (const Message* message = reader.next()) {
    must(before_ns <= message->log_ns, "times do not fall");
    before_ns = message->log_ns;
    for (const auto byte : message->data) sum += byte;
  }
  must(sum != 0xffffffffU, "every byte can be read");  // no input has so many
}

/// Asks for what was so in the middle, by message indexes, which may lie.
void find_newest(const ByteSource& source) {
  const auto summary = summarize(source, Depth::kIndexes);
  if (!summary) return;
  const auto& blocks = summary.value().blocks;
  BlockChannels channels(source, blocks);
  NewestMessages newest(source, blocks, channels);
  const auto& times = summary.value().statistics;
  const std::uint64_t middle_ns = times.start_ns / 2 + times.end_ns / 2;
  for (const auto& each : newest.before(middle_ns, {{.channels = {1, 2, 3}, .most = 3}}).messages)
    must(each.head.log_ns < middle_ns, "nothing is later");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes file(std::begin(kMagic), std::end(kMagic));  // without it there is nothing to read
  file.insert(file.end(), data, data + size);
  const MemorySource source(file);
  const auto summary = summarize(source, Depth::kAll);
  if (!summary) return 0;
  read_all(source, summary.value(), std::size_t{1} << 20);
  read_all(source, summary.value(), 1);
  find_newest(source);
  return 0;
}
