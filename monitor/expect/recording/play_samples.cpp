// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/recording/play_samples.h"

#include <algorithm>
#include <limits>

#include "core/visible_text.h"
#include "monitor/expect/recording/channel_decoder.h"
#include "monitor/mcap/mcap_scan.h"

namespace galilean::expect {
namespace {

/// A time beyond this is damage or nonsense: the year 2262 ends what 64 bits can count.
std::int64_t to_time(std::uint64_t log_ns) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max() / 2;
  return static_cast<std::int64_t>(std::min(log_ns, kMost));
}

class Playing {
 public:
  Playing(const mcap::Summary& summary, SampleSink& sink) : decoders_(summary, sink), sink_(sink) {}

  void take(const mcap::Message& message) {
    const std::int64_t at_ns = to_time(message.log_ns);
    played_.begin_ns = played_.messages == 0 ? at_ns : std::min(played_.begin_ns, at_ns);
    played_.end_ns = std::max(played_.end_ns, at_ns);
    ++played_.messages;
    if (decoders_.take(at_ns, message)) return;
    if (played_.undecoded++ == 0)
      sink_.damage({at_ns, at_ns},
                   "a message of " + decoders_.topic(message.channel_id) + " is not whole");
    else
      sink_.damage({at_ns, at_ns}, {});
  }

  /// The reader tells no time of what is damaged, so that it may be any.
  Played end(const mcap::ScanEnd& end) {
    const Span any{std::numeric_limits<std::int64_t>::min(),
                   std::numeric_limits<std::int64_t>::max()};
    for (const auto& damage : end.damage) sink_.damage(any, "damaged: " + visible(damage));
    if (!end.complete)
      played_.notes.push_back("the recording was not closed; it is judged as far as it goes");
    std::ranges::move(decoders_.notes(), std::back_inserter(played_.notes));
    return std::move(played_);
  }

 private:
  ChannelDecoders decoders_;
  SampleSink& sink_;
  Played played_;
};

}  // namespace

Played play_samples(const mcap::ByteSource& recording, const mcap::Summary& summary,
                    SampleSink& sink) {
  Playing playing(summary, sink);
  mcap::Visitor visitor;
  visitor.message = [&](const mcap::Message& message) { playing.take(message); };
  return playing.end(mcap::scan(recording, visitor));
}

}  // namespace galilean::expect
