// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/playback/recorded_topics.h"
#include "monitor/recordings/recording_folder.h"

namespace galilean::monitor {

/// A recording that is open for a viewer: what it holds, and what is to be said of it.
struct ViewedRecording {
  std::string name;
  std::shared_ptr<const mcap::FileSource> source;
  mcap::Summary summary;
  std::vector<RecordedTopic> topics;

  /// Errors: it cannot be opened, is no recording or has no message. The error is a sentence.
  [[nodiscard]] static Result<ViewedRecording> open(const RecordingFolder& folder,
                                                    const std::string& name);
};

/// What is damaged in a recording, in sentences for its viewer. Each damage is told once, and after
/// a hundred of them only that there are more.
class DamageTeller {
 public:
  explicit DamageTeller(const ViewedRecording& recording) : recording_(recording) {}

  /// Returns what is known before the recording is played, as sentences.
  [[nodiscard]] std::vector<std::string> known();
  /// Returns those of the damages that were not told yet, as sentences.
  [[nodiscard]] std::vector<std::string> newly(const std::vector<mcap::Damage>& met);

 private:
  const ViewedRecording& recording_;
  std::set<std::uint64_t> told_;  ///< by offset
};

}  // namespace galilean::monitor
