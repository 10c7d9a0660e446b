// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/live/live_samples.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "monitor/wire/topic_name.h"

namespace galilean::expect {
namespace {

constexpr Duration kLookForTopicsEach = std::chrono::milliseconds(200);
constexpr std::size_t kMostNotes = 20;

/// Returns whether all that write the topic have this release's definition of its type.
bool is_ours(const monitor::FoundTopic& topic) {
  return std::ranges::all_of(topic.ends, [](const wire::EndpointInfo& end) {
    const auto definition = monitor::definition_of(end);
    return definition == monitor::Definition::kOurs ||
           definition == monitor::Definition::kUnpublished;
  });
}

}  // namespace

LiveSamples::LiveSamples(monitor::WireSession& session, SampleSink& sink)
    : session_(session),
      sink_(sink),
      typed_(sink),
      began_(session.now()),
      began_ns_(wire::wall_clock_ns()) {}

std::int64_t LiveSamples::time_ns(Time at) const {
  return began_ns_ + (at - began_).count();
}

void LiveSamples::pump() {
  if (const Time now = session_.now(); now >= next_look_) {
    next_look_ = now + kLookForTopicsEach;
    open_new();
  }
  for (auto& [name, topic] : topics_)
    if (topic.reader) take(topic);
}

void LiveSamples::open_new() {
  std::map<std::string, monitor::FoundTopic> found;
  for (const auto& end : session_.known()) {
    if (!end.writes || !end.topic.starts_with("rt/") || topics_.contains(end.topic)) continue;
    auto& topic = found[end.topic];
    topic.dds_topic = end.topic;
    topic.ends.push_back(end);
  }
  for (auto& [name, topic] : found) open(std::move(topic));
}

void LiveSamples::open(monitor::FoundTopic found) try {
  const std::string type = monitor::shown_type(found.ends.front().dds_type);
  Topic& topic = topics_[found.dds_topic];
  topic.name = monitor::shown_topic(found.dds_topic);
  topic.counted = sink_.wants_messages(topic.name);
  topic.fields = sink_.wants_fields(topic.name);
  const bool typed = sink_.wants_type(type), ours = is_ours(found);
  if (typed && ours) topic.decode = TypedDecoder::function_for(type);
  if (typed && !ours)
    note(visible(topic.name) + " is not judged: its writer defines " + visible(type) +
         " otherwise than this release");
  if (topic.counted || topic.fields || topic.decode) topic.reader = session_.read(std::move(found));
} catch (const std::exception& error) {
  note(std::string("a topic cannot be read: ") + error.what());
}

void LiveSamples::take(Topic& topic) {
  topic.reader->take([&](const wire::Received& received) {
    const Time now = session_.now();
    if (!first_) first_ = now;
    ++played_.messages;
    give(topic, received, time_ns(now));
  });
  for (const auto& each : topic.reader->take_notes()) note(each);
}

void LiveSamples::give(Topic& topic, const wire::Received& received, std::int64_t at_ns) {
  if (topic.counted) sink_.message(at_ns, topic.name, {received.writer, received.sequence});
  const bool typed = !topic.decode || (typed_.*topic.decode)(at_ns, received.cdr);
  const bool fields = !topic.fields || give_fields(topic, received, at_ns);
  if (typed && fields) return;
  const bool first = played_.undecoded++ == 0;
  sink_.damage({at_ns, at_ns}, first ? "a message of " + visible(topic.name) +
                                           " is not whole, or "
                                           "its definition is not known"
                                     : std::string());
}

bool LiveSamples::give_fields(Topic& topic, const wire::Received& received, std::int64_t at_ns) {
  const auto decoded = topic.reader->decode(received);
  if (!decoded) return note(decoded.error().message), false;
  sink_.fields(at_ns, topic.name, decoded.value());
  return true;
}

void LiveSamples::note(const std::string& sentence) {
  if (notes_.size() < kMostNotes && notes_.insert(sentence).second)
    played_.notes.push_back(sentence);
}

Played LiveSamples::finish() {
  pump();
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
