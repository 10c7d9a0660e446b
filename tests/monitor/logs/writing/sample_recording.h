// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/result.h"
#include "monitor/mcap/mcap_writer.h"

namespace galilean::logs {

/// A message of a recording, with its own bytes.
struct Sample {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_ns = 0;
  mcap::Bytes data;
  bool operator==(const Sample&) const = default;
};

/// Returns some seconds of messages of three topics, by a seed.
[[nodiscard]] std::vector<Sample> random_samples(unsigned seed);

/// Writes the samples as a recorder does: each as it comes, and a chunk whenever its second is
/// over, with metadata before and an attachment between them. `accepted` is called with how many
/// the writer has taken. Errors: those of the sink.
Result<void> write_samples(const std::vector<Sample>& samples, mcap::ByteSink& sink,
                           mcap::Compression compression,
                           const std::function<void(std::size_t)>& accepted);

/// Returns the messages of a whole recording; nothing if it is not whole.
[[nodiscard]] std::optional<std::vector<Sample>> read_samples(const mcap::ByteSource& source);

}  // namespace galilean::logs
