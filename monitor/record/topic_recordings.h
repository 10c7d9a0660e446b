// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "monitor/record/losses.h"
#include "monitor/record/match_watch.h"
#include "monitor/record/selection.h"
#include "monitor/record/topic_recording.h"

namespace galilean::monitor {

/// Receives the messages of all writers of the domain that a selection takes, and of those that are
/// overheard. For use by one thread.
class TopicRecordings {
 public:
  struct Setup {
    wire::Participant& participant;  ///< outlives this
    Selection selection;
    /// Which writers are heard though they are not selected. Nothing of them is counted. May be
    /// left empty.
    std::function<bool(const wire::EndpointInfo&)> overhears = {};
    std::function<void(const std::string&)> warn;  ///< gets a sentence for what is not heard
    std::function<void()> on_data;  ///< a thread of Cyclone calls it when there is data to take
  };

  explicit TopicRecordings(Setup setup)
      : setup_(std::move(setup)), endpoints_(setup_.participant) {}

  /// Receives what those writers send, too, that have come since the last call.
  void follow_writers();
  /// Calls `receive` for each message that came since the last call, and that has not come before.
  void take(const TopicRecording::Receive& receive);
  /// Warns of writers that DDS does not connect. Call it once a second.
  void watch_matches();

  /// Returns the writers and readers that are in the domain now.
  [[nodiscard]] std::vector<wire::EndpointInfo> present() { return endpoints_.known(); }
  /// Returns the number of topics that are recorded.
  [[nodiscard]] std::size_t topics() const;
  /// Returns what came and what did not of what is recorded, by topic and writer.
  [[nodiscard]] std::vector<WriterLosses> losses() const;
  /// Returns whether there were topics that the selection leaves out.
  [[nodiscard]] bool left_out_topics() const noexcept { return left_out_topics_; }

 private:
  void follow(const wire::EndpointInfo& writer);
  [[nodiscard]] TopicRecording& recording_of(const wire::EndpointInfo& writer);
  [[nodiscard]] const TopicRecording* find_recording(const wire::EndpointInfo& writer) const;
  [[nodiscard]] std::optional<wire::EndpointInfo> find_writer(std::uint64_t handle);

  Setup setup_;
  wire::Endpoints endpoints_;
  MatchWatch matches_;
  std::map<TopicRecording::Kind, std::unique_ptr<TopicRecording>> recordings_;
  std::set<std::string> refused_;  ///< GUIDs of writers for which Cyclone refused a reader
  bool left_out_topics_ = false;
};

}  // namespace galilean::monitor
