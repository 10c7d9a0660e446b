// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/live/live_samples.h"

#include <algorithm>
#include <utility>

#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "monitor/record/told_losses.h"
#include "monitor/wire/topic_name.h"

namespace galilean::expect {
namespace {

constexpr Duration kLookForWritersEach = std::chrono::milliseconds(200);
constexpr Duration kWatchMatchesEach = std::chrono::seconds(1);
constexpr std::size_t kMostNotes = 20;

}  // namespace

LiveSamples::LiveSamples(monitor::WireSession& session, SampleSink& sink)
    : session_(session),
      sink_(sink),
      decoders_(session.definitions(), sink),
      recordings_({.participant = session.participant(),
                   .selection = {.wants = [this](const auto& end) { return decoders_.wants(end); }},
                   .warn = [this](const std::string& sentence) { note(sentence); },
                   .on_data = [this] { session_.ring(); }}),
      began_(session.now()),
      began_ns_(wire::wall_clock_ns()) {}

std::int64_t LiveSamples::time_ns(Time at) const {
  return began_ns_ + (at - began_).count();
}

void LiveSamples::pump() {
  const Time now = session_.now();
  if (now >= next_look_) {
    next_look_ = now + kLookForWritersEach;
    recordings_.follow_writers();
  }
  if (now >= next_watch_) {
    next_watch_ = now + kWatchMatchesEach;
    recordings_.watch_matches();
  }
  recordings_.take(
      [this](const wire::Received& received, const monitor::TopicRecording::Writer& writer) {
        take(received, writer.info);
      });
  for (const auto& sentence : decoders_.take_notes()) note(sentence);
}

void LiveSamples::take(const wire::Received& received, const wire::EndpointInfo& writer) {
  const Time now = session_.now();
  if (!first_) first_ = now;
  ++played_.messages;
  const auto at_ns = time_ns(now);
  if (decoders_.take(at_ns, writer, received)) return;
  const bool first = played_.undecoded++ == 0;
  sink_.damage({at_ns, at_ns}, first
                                   ? "a message of " + visible(monitor::shown_topic(writer.topic)) +
                                         " is not whole, or its definition is not known"
                                   : std::string());
}

void LiveSamples::note(const std::string& sentence) {
  if (notes_.size() < kMostNotes && notes_.insert(sentence).second)
    played_.notes.push_back(sentence);
}

Played LiveSamples::finish() {
  pump();
  const monitor::ToldLosses losses{recordings_.losses(), true};
  for (const auto& [topic, missed] : monitor::missing_by_topic(losses, {}))
    sink_.missed(topic, missed);
  played_.begin_ns = time_ns(first_.value_or(began_));
  played_.end_ns = time_ns(session_.now());
  return std::move(played_);
}

Played listen(monitor::WireSession& session, SampleSink& sink, Duration enough_for) {
  LiveSamples samples(session, sink);
  const Time start = session.now();
  session.wait(2 * enough_for, [&] {
    samples.pump();
    return session.now() - samples.first().value_or(start) >= enough_for;
  });
  return samples.finish();
}

}  // namespace galilean::expect
