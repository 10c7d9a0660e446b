// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "core/wire/schemas.h"
#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/mcap_writer.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::monitor {

/// Returns a recording of the states of one robot, one each second from `start_ns` on, of so many
/// bytes each.
inline mcap::Bytes recording_of_states(const std::string& robot, int states,
                                       std::uint64_t start_ns = 1'700'000'000'000'000'000,
                                       std::size_t bytes = 1) {
  constexpr const char* kType = "galilean_msgs/msg/RobotState";
  mcap::FaultyDisk disk;
  mcap::Writer writer(disk, {.chunk_bytes = 100});
  (void)writer.begin();
  const auto schema =
      writer.add_schema(kType, "ros2idl", std::string(wire::find_schema_by_ros_type(kType)->idl));
  (void)writer.add_channel(
      {.schema_id = schema, .topic = "/" + robot + "/state", .message_encoding = "cdr"});
  for (int i = 0; i < states; ++i) {
    const auto log_ns = start_ns + static_cast<std::uint64_t>(i) * 1'000'000'000;
    const mcap::Bytes data(bytes, static_cast<std::uint8_t>(i));
    (void)writer.write(mcap::Message{1, static_cast<std::uint32_t>(i), log_ns, log_ns, data});
  }
  (void)writer.end();
  return disk.bytes();
}

/// Returns a recording of 20 states that is whole at a glance, of which a chunk is damaged.
inline mcap::Bytes damaged_recording() {
  auto bytes = recording_of_states("io", 20);
  const auto blocks = mcap::summarize(mcap::MemorySource(bytes)).value().blocks;
  const auto& chunk = blocks.at(blocks.size() / 2);
  bytes[chunk.offset + chunk.bytes - 1] ^= 0x55;
  return bytes;
}

inline void write_file(const std::filesystem::path& path, const mcap::Bytes& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

}  // namespace galilean::monitor
