// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "monitor/expect/judge/samples.h"
#include "monitor/mcap/mcap_reader.h"

namespace galilean::expect {

/// What was read of a recording.
struct Played {
  std::int64_t begin_ns = 0, end_ns = 0;  ///< of its messages, since the Unix epoch
  std::uint64_t messages = 0;
  std::uint64_t undecoded = 0;     ///< messages that are not whole messages of their type
  std::vector<std::string> notes;  ///< a sentence on each topic that is asked about and not decoded
};

/// Gives a recording's messages to `sink`, by the times at which they were received. Damaged parts
/// are left out and told as damage. Requires: `summary` is that of `recording`.
[[nodiscard]] Played play_samples(const mcap::ByteSource& recording, const mcap::Summary& summary,
                                  SampleSink& sink);

}  // namespace galilean::expect
