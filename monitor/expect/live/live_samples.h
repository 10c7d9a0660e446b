// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>

#include "monitor/expect/live/writer_decoders.h"
#include "monitor/expect/recording/play_samples.h"
#include "monitor/record/topic_recordings.h"
#include "monitor/wire/wire_session.h"

namespace galilean::expect {

/// Gives the messages of a DDS domain to a sink as they come, as play_samples gives those of a
/// recording. It hears as the recorder does the topics that the sink wants: each message once,
/// whatever quality of service its writer offers, and counts what does not come.
///
/// Times are those at which messages were received. They begin with this machine's wall clock, and
/// then go on by its monotonic clock, so that no setting of the clock shows in them. For one
/// thread.
class LiveSamples {
 public:
  /// Requires: both outlive this.
  LiveSamples(monitor::WireSession& session, SampleSink& sink);

  /// Takes what came since the last call. Never waits for more.
  void pump();
  /// Returns when the first message came; nothing if none did.
  [[nodiscard]] std::optional<Time> first() const noexcept { return first_; }
  /// Returns what was heard until now. Call it once, at the end.
  [[nodiscard]] Played finish();

 private:
  void take(const wire::Received& received, const wire::EndpointInfo& writer);
  void note(const std::string& sentence);
  [[nodiscard]] std::int64_t time_ns(Time at) const;

  monitor::WireSession& session_;
  SampleSink& sink_;
  WriterDecoders decoders_;
  monitor::TopicRecordings recordings_;
  const Time began_;
  const std::int64_t began_ns_;  ///< the same instant by the wall clock
  Time next_look_{}, next_watch_{};
  std::optional<Time> first_;
  std::set<std::string> notes_;
  Played played_;
};

/// Listens until `enough_for` is over since the first message, or since the call if none comes in
/// that time, or until termination is asked for. Returns what was heard.
[[nodiscard]] Played listen(monitor::WireSession& session, SampleSink& sink, Duration enough_for);

}  // namespace galilean::expect
