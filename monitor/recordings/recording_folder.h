// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/mcap/byte_source.h"

namespace galilean::monitor {

/// Why a recording cannot be opened.
struct NotOpened {
  enum class Why {
    kNotThere,    ///< there is no such name, or what has it leads out of the folder
    kForbidden,   ///< the monitor may not read it
    kNoFile,      ///< it is a folder, a pipe, a socket or a device
    kUnreadable,  ///< the system says another reason
  };
  Why why = Why::kNotThere;
  std::string message;  ///< a sentence that names the recording
};

/// A recording that is open for reading. Who deletes or replaces it meanwhile changes nothing here.
struct OpenedRecording {
  std::shared_ptr<const mcap::FileSource> source;
  std::uint64_t bytes = 0;
  std::uint64_t modified_ns = 0;  ///< since the Unix epoch
  std::uint64_t inode = 0;
};

/// The one folder whose recordings a monitor shows. Names lead to files in it and never out of it,
/// neither by ".." nor by links. All calls may block on the disk.
class RecordingFolder {
 public:
  /// The folder need not exist.
  explicit RecordingFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return folder_; }
  /// Errors: the recording cannot be opened. A file of another kind can.
  [[nodiscard]] Result<OpenedRecording, NotOpened> open(const std::string& name) const;
  /// Returns the names of what could be recordings, sorted; none if the folder does not exist. Some
  /// may be names that cannot be opened; see check_recording_name().
  /// Errors: the folder cannot be read. The error is a sentence.
  [[nodiscard]] Result<std::vector<std::string>> names() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace galilean::monitor
