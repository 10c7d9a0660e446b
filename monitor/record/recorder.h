// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/wake.h"
#include "core/wire/discovery.h"
#include "core/wire/participant.h"
#include "monitor/record/byte_budget.h"
#include "monitor/record/channels.h"
#include "monitor/record/disk_room.h"
#include "monitor/record/gap_watch.h"
#include "monitor/record/kept_messages.h"
#include "monitor/record/losses.h"
#include "monitor/record/message_ring.h"
#include "monitor/record/pause_log.h"
#include "monitor/record/program_changes.h"
#include "monitor/record/program_texts.h"
#include "monitor/record/recording_files.h"
#include "monitor/record/selection.h"
#include "monitor/record/snapshots.h"
#include "monitor/record/topic_recordings.h"
#include "monitor/wire/definitions.h"

namespace galilean::monitor {

/// Reads all topics of the domain and writes their bytes unchanged to MCAP files. A topic is read
/// as soon as it has a writer, whatever its type and its quality of service. A message's log time
/// is when it was received, by this machine's clock. Its publish time is when it was sent, by its
/// writer's clock. Topics have their ROS names: /io/state. What is lost is counted, and written
/// into the files, too. While the disk is nearly full nothing is written, which is said and
/// counted. A file that follows another begins with the newest message of every state. The texts of
/// programs are attached, and metadata tells which robot runs which, and when that changes.
///
/// With a trigger, nothing is written until something happens. Then a file begins with what came
/// shortly before, and with the states that were so then, and ends some time after the last event.
///
/// While it is paused it writes nothing, and what comes is no loss. It goes on with what the states
/// are then. A pause empties what is kept for a trigger.
///
/// For use by one thread, which calls `pump` when `descriptor` is readable, and at least each
/// second.
class Recorder {
 public:
  struct Setup {
    wire::Participant& participant;
    const Clock& clock;
    RecordingFiles& files;
    DiskRoom room;
    mcap::Text about;  ///< what each file tells of who recorded it
    Selection selection;
    SchemaLanguage language = SchemaLanguage::kMessage;
    std::uint64_t picture_bytes_per_s = 0;  ///< what pictures may take; 0: without a limit
    Snapshots snapshots = {};
    std::function<void(const std::string&)> warn;  ///< gets a sentence for what is not as it should
    std::function<bool()> ended;                   ///< whether waiting should end
  };

  /// Requires: what `setup` refers to outlives this.
  explicit Recorder(Setup setup);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Begins the first file, unless a trigger has to. Call it once, before `pump`. Errors: it cannot
  /// be written.
  [[nodiscard]] Result<void> begin();
  [[nodiscard]] int descriptor() const noexcept { return wake_.descriptor(); }
  /// Records the messages that came since the last call. It may block for 3 s at the first message
  /// of a type that this release does not define. Errors: the file cannot be written.
  [[nodiscard]] Result<void> pump();
  /// Writes what was lost into the open file and ends it. A file that has ended because the disk is
  /// nearly full is told what was not written since. Call it last. Errors: the file cannot be
  /// written, or has been deleted or spoilt.
  [[nodiscard]] Result<void> conclude();

  /// Records what has come until now, and then nothing until `resume`. `by` is who asks for it.
  /// Does nothing while it is paused. Errors: the file cannot be written.
  [[nodiscard]] Result<void> pause(const std::string& by);
  /// Goes on. Returns the pause that has ended; nothing if it was not paused. Errors: the file
  /// cannot be written.
  [[nodiscard]] Result<std::optional<Pause>> resume();
  /// Returns the pause that is going on; nothing while it records.
  [[nodiscard]] const std::optional<Pause>& paused() const noexcept { return pause_; }

  /// Returns what is read, what came and what did not.
  [[nodiscard]] const TopicRecordings& recordings() const noexcept { return recordings_; }

 private:
  /// What each file has of its own.
  struct Contents {
    Channels channels;
    LossLog losses;
    PauseLog pauses;
    ProgramTexts programs;
    ProgramChanges program_changes;
  };

  [[nodiscard]] Result<void> record();
  [[nodiscard]] Result<void> take_in(const wire::Received& received,
                                     TopicRecording::Writer& writer);
  /// Returns whether a writer is heard though it is not recorded.
  [[nodiscard]] bool overhears(const wire::EndpointInfo& writer) const;
  [[nodiscard]] Result<void> keep(const wire::Received& received, TopicRecording::Writer& writer,
                                  Time now, bool fills_gap);
  void pass_over(const wire::Received& received, TopicRecording::Writer& writer);
  [[nodiscard]] Result<void> follow_events(Time now);
  [[nodiscard]] Result<void> begin_snapshot(const std::string& event);
  void remember_losses(Time now);
  [[nodiscard]] Result<void> write(const wire::EndpointInfo& writer, const wire::Received& received,
                                   std::int64_t log_ns);
  [[nodiscard]] Result<void> attach_programs(const wire::EndpointInfo& writer,
                                             const wire::Received& received);
  [[nodiscard]] Result<void> look_after_files(Time now);
  [[nodiscard]] Result<void> watch_file();
  [[nodiscard]] Result<void> stand_still();
  /// Writes into the open file what stands at its end.
  [[nodiscard]] Result<void> write_end();
  void tell_what_came_since();
  /// `log_ns` is the log time of the states that the file begins with.
  [[nodiscard]] Result<void> begin_file(std::int64_t log_ns);
  /// Writes the states that writers keep, or only those of `writers`.
  [[nodiscard]] Result<void> write_kept(std::int64_t log_ns,
                                        const std::set<std::string>* writers = nullptr);
  /// Says why a trigger cannot come true, as far as is known.
  void say_doubts();
  void warn_once(const std::string& sentence);

  Setup setup_;
  Wake wake_;
  std::atomic<bool> writers_changed_{true};
  TopicRecordings recordings_;
  Definitions definitions_;
  std::optional<Contents> contents_;     ///< of the open file
  std::vector<WriterLosses> concluded_;  ///< what was told at the end of the newest file that ended
  KeptMessages kept_;
  GapWatch gaps_;
  std::optional<Pause> pause_;              ///< the one that is going on
  std::uint64_t pauses_ = 0;                ///< that have begun
  std::set<std::string> changed_in_pause_;  ///< GUIDs of the writers whose messages came in it
  /// What may belong to a snapshot; nothing if all is written. What leaves it is in `kept_`.
  std::optional<MessageRing> ring_;
  std::string event_;      ///< for which the open file was begun
  Time snapshot_until_{};  ///< when it ends
  std::deque<std::pair<Time, std::vector<WriterLosses>>> losses_then_;  ///< since the ring begins
  ByteBudget picture_budget_;
  std::set<std::string> warned_;  ///< what was said
  std::optional<Time> looked_;
  wire::Discovery discovery_;  ///< last, because its callback uses the others
};

}  // namespace galilean::monitor
