// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core/wake.h"
#include "core/wire/discovery.h"
#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "monitor/record/channels.h"
#include "monitor/record/disk_room.h"
#include "monitor/record/losses.h"
#include "monitor/record/recording_files.h"
#include "monitor/record/topic_recording.h"
#include "monitor/wire/definitions.h"

namespace galilean::monitor {

/// Reads all topics of the domain and writes their bytes unchanged to MCAP files. A topic is read
/// as soon as it has a writer, whatever its type and its quality of service. A message's log time
/// is when it was received, by this machine's clock. Its publish time is when it was sent, by its
/// writer's clock. Topics have their ROS names: /io/state. What is lost is counted, and written
/// into the files, too. While the disk is nearly full nothing is written, which is said and counted.
///
/// For use by one thread, which calls `pump` when `descriptor` is readable, and at least each
/// second.
class Recorder {
 public:
  struct Selection {
    std::optional<std::regex> topics;  ///< must match a part of a topic's name; none: all topics
    bool images = true;                ///< costly, because robots encode images only for readers
    SchemaLanguage language = SchemaLanguage::kMessage;
  };
  struct Setup {
    wire::Participant& participant;
    RecordingFiles& files;
    DiskRoom room;
    mcap::Text about;  ///< what each file tells of who recorded it
    Selection selection;
    std::function<void(const std::string&)> warn;  ///< gets a sentence for what is not as it should
    std::function<bool()> ended;                   ///< whether waiting should end
  };

  /// Requires: what `setup` refers to outlives this.
  explicit Recorder(Setup setup);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Begins the first file. Call it once, before `pump`. Errors: it cannot be written.
  [[nodiscard]] Result<void> begin() { return begin_file(); }
  [[nodiscard]] int descriptor() const noexcept { return wake_.descriptor(); }
  /// Records the messages that came since the last call. It may block for 3 s at the first message
  /// of a type that this release does not define. Errors: the file cannot be written.
  [[nodiscard]] Result<void> pump();
  /// Writes what was lost into the open file and ends it. Call it last. Errors: the file cannot be
  /// written.
  [[nodiscard]] Result<void> conclude();

  /// Returns the number of topics that are read.
  [[nodiscard]] std::size_t topics() const;
  /// Returns what came and what did not, by topic and writer.
  [[nodiscard]] std::vector<WriterLosses> losses() const;
  /// Returns whether there were topics that the selection leaves out.
  [[nodiscard]] bool left_out_topics() const noexcept { return !left_out_.empty(); }

 private:
  using Recordings = std::map<TopicRecording::Kind, std::unique_ptr<TopicRecording>>;
  /// What each file has of its own.
  struct Contents {
    Channels channels;
    LossLog losses;
  };

  [[nodiscard]] bool is_selected(const wire::EndpointInfo& writer) const;
  void follow_writers();
  void follow(const wire::EndpointInfo& writer);
  Result<void> record(TopicRecording& recording);
  Result<void> look_after_files();
  Result<void> stand_still();
  Result<void> begin_file();

  Setup setup_;
  Wake wake_;
  std::atomic<bool> writers_changed_{true};
  wire::Endpoints endpoints_;
  Definitions definitions_;
  std::optional<Contents> contents_;  ///< of the open file
  Recordings recordings_;
  std::set<TopicRecording::Kind> refused_;  ///< by Cyclone
  std::set<std::string> left_out_;          ///< topics
  std::int64_t looked_ns_ = 0;
  wire::Discovery discovery_;  ///< last, because its callback uses the others
};

}  // namespace galilean::monitor
