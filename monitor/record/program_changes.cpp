// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/program_changes.h"

#include "core/wire/decode_untrusted.h"
#include "core/wire/messages.h"
#include "core/wire/ros_time.h"
#include "monitor/record/times.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {

std::optional<mcap::Metadata> ProgramChanges::note(const wire::EndpointInfo& writer,
                                                   const wire::Received& received,
                                                   std::int64_t log_ns) {
  msg::Program program;
  if (shown_type(writer.dds_type) != msg::Program::kRosType) return std::nullopt;
  if (!wire::decode_untrusted(received.cdr, program)) return std::nullopt;
  if (hashes_.size() >= kMostRobots && !hashes_.contains(program.robot)) return std::nullopt;
  const auto [known, is_new] = hashes_.try_emplace(program.robot, program.hash);
  if (!is_new && known->second == program.hash) return std::nullopt;
  known->second = program.hash;
  const auto since_ns = static_cast<std::uint64_t>(wire::since_epoch_ns(program.stamp));
  return mcap::Metadata{kProgramMetadata,
                        {{"robot", program.robot},
                         {"hash", program.hash},
                         {"name", program.name},
                         {"since", iso_time(since_ns)},
                         {"received", iso_time(static_cast<std::uint64_t>(log_ns))}}};
}

}  // namespace galilean::monitor
