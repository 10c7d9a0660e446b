// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/recording/play_samples.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "monitor/expect/recording/channel_decoder.h"
#include "monitor/mcap/message_reader.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/told_losses.h"
#include "monitor/record/told_pauses.h"
#include "monitor/replay/report.h"

namespace galilean::expect {
namespace {

/// A time beyond this is damage or nonsense: the year 2262 ends what 64 bits can count.
std::int64_t to_time(std::uint64_t log_ns) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max() / 2;
  return static_cast<std::int64_t>(std::min(log_ns, kMost));
}

class Playing {
 public:
  Playing(const mcap::Summary& summary, SampleSink& sink)
      : summary_(summary), decoders_(summary, sink), sink_(sink) {}

  void take(const mcap::Message& message) {
    const std::int64_t at_ns = to_time(message.log_ns);
    if (played_.messages++ == 0) played_.begin_ns = at_ns;
    played_.end_ns = at_ns;  // because messages come in the order of their times
    time_.move_to(message.log_ns);
    if (decoders_.take(at_ns, message)) return;
    const bool first = played_.undecoded++ == 0;
    sink_.damage({at_ns, at_ns},
                 first ? "a message of " + decoders_.topic(message.channel_id) + " is not whole"
                       : std::string());
  }

  void tell(const monitor::ToldLosses& losses) {
    for (const auto& [topic, missed] : monitor::missing_by_topic(losses, summary_))
      sink_.missed(topic, missed);
  }

  /// What a file lacked is missing in its copies, too.
  void tell(const monitor::CopyLosses& losses) {
    const std::string text = monitor::copy_loss_text(losses);
    if (losses.times.empty()) return sink_.damage(kAnyTime, text);
    for (bool is_first = true; const auto& time : losses.times)
      sink_.damage({to_time(time.start_ns), to_time(time.end_ns)},
                   std::exchange(is_first, false) ? text : std::string());
  }

  /// What came in a pause is unknown, and nothing of it is lost.
  void tell(const monitor::Pause& pause) {
    const auto end_ns = pause.to_ns.value_or(std::max(pause.from_ns, played_.end_ns));
    sink_.damage({pause.from_ns, end_ns}, "the recording was " + monitor::pause_text(pause));
  }

  /// @param met  the damage that was met in reading
  Played end(const std::vector<mcap::Damage>& met) {
    for (const auto& damage : summary_.damages) tell(damage);
    for (const auto& damage : monitor::newly_met(met, summary_)) tell(damage);
    for (const auto& copy : monitor::copy_losses(summary_)) tell(copy);
    tell_whether_it_ends();
    std::ranges::move(decoders_.notes(), std::back_inserter(played_.notes));
    for (const auto& silence : time_.silences())
      played_.silences.push_back({to_time(silence.start_ns), to_time(silence.end_ns)});
    return std::move(played_);
  }

 private:
  /// What a recording that was not closed has lost behind its last message is not known.
  void tell_whether_it_ends() {
    if (summary_.being_written)
      played_.notes.emplace_back("the recording is being written; it is judged as far as it goes");
    else if (!summary_.closed)
      sink_.damage({played_.end_ns + 1, kAnyTime.to_ns},
                   "the recording was not closed; what came after its last message is not known");
  }

  /// The judge is told only of what loses messages.
  void tell(const mcap::Damage& damage) {
    const std::string text = "damaged: " + monitor::damage_text(damage, summary_);
    if (damage.messages == std::uint64_t{0}) return played_.notes.push_back(text);
    const Span span =
        damage.time ? Span{to_time(damage.time->start_ns), to_time(damage.time->end_ns)} : kAnyTime;
    sink_.damage(span, text);
  }

  const mcap::Summary& summary_;
  ChannelDecoders decoders_;
  SampleSink& sink_;
  mcap::RecordingTime time_;
  Played played_;
};

}  // namespace

Played play_samples(const mcap::ByteSource& recording, const mcap::Summary& summary,
                    SampleSink& sink, const mcap::Progress& progress) {
  constexpr std::uint64_t kTellEach = 256;  // messages
  Playing playing(summary, sink);
  mcap::MessageReader reader(recording, summary.blocks);
  for (std::uint64_t read = 0; const mcap::Message* message = reader.next(); ++read) {
    if (progress && read % kTellEach == 0) progress(reader.progress());
    playing.take(*message);
  }
  if (const auto losses = monitor::told_losses(recording, summary)) playing.tell(*losses);
  for (const auto& pause : monitor::told_pauses(recording, summary)) playing.tell(pause);
  return playing.end(reader.damages());
}

}  // namespace galilean::expect
