// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/progress_bar.h"
#include "monitor/logs/reading/recording.h"
#include "monitor/mcap/message_reader.h"

namespace galilean::logs {

/// Which messages of a recording are wanted. Times are seconds since its start, without silences,
/// as `galilean replay --from` counts them.
struct Selection {
  std::vector<std::string> topics;  ///< none: all
  double from_s = 0;
  std::optional<double> to_s;  ///< nothing: up to the end
};

/// Returns what is wanted as words behind "no message": " of io/state from 90 s on up to 95 s".
/// Returns an empty text if all is wanted.
[[nodiscard]] std::string part_text(const Selection& selection);
/// Whether a terminal shows how far a command has read.
enum class ShowsProgress {
  kYes,
  kUnlessPrinting,  ///< the command prints meanwhile: not where its lines go to a terminal
  kNo
};

/// Reads the wanted messages of a recording in the order of their log times, in bounded memory.
class SelectedMessages {
 public:
  static constexpr std::size_t kMemoryBytes = std::size_t{48} << 20;

  /// Errors: a topic is not there. Requires: the recording stays where it is, and outlives this.
  [[nodiscard]] static Result<SelectedMessages> of(const Recording& recording,
                                                   const Selection& selection,
                                                   std::size_t memory_bytes = kMemoryBytes,
                                                   ShowsProgress shows = ShowsProgress::kYes);

  /// Returns the next message; nothing after the last. Its data is valid until the next call.
  [[nodiscard]] const mcap::Message* next();
  /// Returns the time of the newest message [s since the start, without silences].
  [[nodiscard]] double at_s() const noexcept {
    return static_cast<double>(time_.position_ns()) * 1e-9;
  }
  [[nodiscard]] const Recording& recording() const noexcept { return *recording_; }
  /// Returns whether the topic of a channel is wanted.
  [[nodiscard]] bool takes_channel(std::uint16_t id) const {
    return all_topics_ || channels_.contains(id);
  }
  /// Returns whether all topics are wanted.
  [[nodiscard]] bool takes_all_topics() const noexcept { return all_topics_; }
  /// Returns whether there was a message yet.
  [[nodiscard]] bool any() const noexcept { return any_; }
  /// Returns the log times of a selection's part; nothing if it is all of the recording's time.
  /// Requires: all was read.
  [[nodiscard]] std::optional<mcap::TimeRange> log_times(const Selection& selection) const;
  /// Returns what was damaged of all that was read so far, and of the file as a whole.
  [[nodiscard]] std::vector<mcap::Damage> damages() const;

 private:
  SelectedMessages(const Recording& recording, const Selection& selection,
                   std::size_t memory_bytes);
  [[nodiscard]] bool is_wanted(const mcap::Message& message) const;

  const Recording* recording_;
  double from_s_, to_s_;
  bool all_topics_;
  std::unordered_set<std::uint16_t> channels_;  ///< if not all topics are wanted
  std::unique_ptr<mcap::MessageReader> reader_;
  std::unique_ptr<ProgressBar> bar_;  ///< nothing: none is shown
  std::uint64_t read_ = 0;            ///< messages
  bool any_ = false;                  ///< of those that are wanted
  mcap::RecordingTime time_;
};

/// Returns "there is no message from 90 s on; run.mcap ends at 60 s". Requires: all was read.
[[nodiscard]] std::string nothing_text(const Selection& selection, const SelectedMessages& read);
/// Says on standard error, as `program`, that there is nothing of what was chosen, if that is so.
void tell_nothing(const std::string& program, const Selection& selection,
                  const SelectedMessages& read);
/// Says on standard error, as `program`, what of a recording was left out because it is damaged.
/// Returns the exit code: kIncomplete if anything was, else 0.
[[nodiscard]] int tell_damage(const std::string& program, const SelectedMessages& read);

}  // namespace galilean::logs
