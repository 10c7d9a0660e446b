// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "monitor/recordings/recording_folder.h"

namespace galilean::monitor {

/// What a list says of one recording.
struct ListedRecording {
  std::string name;  ///< as it can be shown
  std::uint64_t bytes = 0;
  std::uint64_t modified_ns = 0;           ///< since the Unix epoch
  std::uint64_t start_ns = 0, end_ns = 0;  ///< log times; 0 without messages
  std::uint64_t messages = 0;
  std::vector<std::string> robots;
  bool complete = false;  ///< its recorder came to its end, and no damage was met
  std::string why;        ///< a sentence if it cannot be opened; else empty
};

/// Lists the recordings of a folder. What a file holds is looked up again only when its size or
/// its time has changed, and, while it is being written, at most every ten seconds. A glance tells
/// most of it; damage is found by reading all, which a call does for the newest that were not read,
/// kMostRead_bytes in all. For use by one thread; a call may block on the disk.
class RecordingList {
 public:
  /// As much is read in less than a second. Larger recordings are looked at only at a glance.
  static constexpr std::uint64_t kMostRead_bytes = 64'000'000;

  /// Requires: `folder` outlives this.
  explicit RecordingList(const RecordingFolder& folder) : folder_(folder) {}

  /// Returns the recordings, the newest first. One whose damage only reading finds may be complete
  /// in one list and not in the next.
  /// Errors: the folder cannot be read. The error is a sentence.
  [[nodiscard]] Result<std::vector<ListedRecording>> list();

 private:
  struct Looked {
    ListedRecording recording;
    std::uint64_t inode = 0;
    std::uint64_t renew_at_ns = 0;  ///< since the Unix epoch; 0: when the file changes
    bool is_read = false;           ///< all of it, so that damage was met
  };
  [[nodiscard]] Looked look(const std::string& name, Looked before) const;
  void read_some(std::vector<ListedRecording>& newest_first);
  [[nodiscard]] bool is_whole(const std::string& name) const;

  const RecordingFolder& folder_;
  std::map<std::string, Looked> looked_;
};

}  // namespace galilean::monitor
