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
  std::vector<std::string> notes;  ///< sentences on what is wrong with it and changes no outcome
  std::vector<Span> silences;      ///< over mcap::kLongestSilence_ns, which a replay passes over
};

/// Gives a recording's messages to `sink` in the order of their log times, in bounded memory. What
/// is lost of it is told as damage, with its time if the recording tells that.
/// `progress` is called now and then.
/// Requires: `summary` is that of `recording`.
[[nodiscard]] Played play_samples(const mcap::ByteSource& recording, const mcap::Summary& summary,
                                  SampleSink& sink, const mcap::Progress& progress = {});

}  // namespace galilean::expect
