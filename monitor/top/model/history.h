// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/ingest/channel.h"

namespace galilean::monitor::top {

/// The messages of the last minutes, as bytes: two a second of each state, and every event. Going
/// back in time and the curves of variables are made of them.
class History {
 public:
  static constexpr Duration kKept = std::chrono::minutes(5);
  static constexpr Duration kEach = std::chrono::milliseconds(500);
  static constexpr std::size_t kEventsKept = 256;

  struct Sample {
    Time received;
    std::int64_t received_ns, sent_ns;
    Payload cdr;
    bool replayed = false;
  };
  struct Track {
    Channel channel;
    std::deque<Sample> samples;  ///< the oldest first
  };

  explicit History(const Clock& clock) : clock_(clock) {}

  void note(const Message& message);
  /// Returns when the oldest message that is still kept was received; now if there is none.
  [[nodiscard]] Time begin() const;
  /// Returns the newest samples of a topic that were received until then, the oldest first, at most
  /// `most`.
  [[nodiscard]] std::vector<Sample> until(const std::string& topic, Time then,
                                          std::size_t most) const;
  [[nodiscard]] const std::map<std::string, Track>& tracks() const noexcept { return tracks_; }

 private:
  const Clock& clock_;
  std::map<std::string, Track> tracks_;  ///< by topic
};

}  // namespace galilean::monitor::top
