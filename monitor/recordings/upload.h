// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "monitor/mcap/byte_sink.h"
#include "monitor/recordings/recording_folder.h"

namespace galilean::monitor {

/// Why a recording cannot be kept.
struct NotKept {
  enum class Why { kNoName, kExists, kTooLarge, kNoRoom, kNoRecording, kUnwritable };
  Why why = Why::kUnwritable;
  std::string message;  ///< a sentence
};

/// What is told of a recording that was kept.
struct KeptRecording {
  bool complete = false;  ///< its recorder came to its end, and no damage was met
  std::string note;       ///< a sentence on what it lacks; empty if it is complete
};

/// A recording that is being put into the folder. It is a hidden draft there until it is whole, and
/// never takes the place of another one. A draft that is not finished is removed. All calls may
/// block on the disk.
class Upload {
 public:
  struct Limits {
    std::uint64_t most_bytes = 10'000'000'000;
    std::uint64_t least_free_bytes = 500'000'000;  ///< what stays free on the disk
  };
  using Kept = Result<void, NotKept>;

  /// Makes the draft, and the folder if it is not there. `bytes` is the size, if it is known.
  /// Errors: the name is none or is taken, or the size is beyond the limits.
  [[nodiscard]] static Result<Upload, NotKept> begin(const RecordingFolder& folder,
                                                     const std::string& name,
                                                     std::optional<std::uint64_t> bytes,
                                                     const Limits& limits);
  Upload(Upload&&) noexcept = default;
  Upload& operator=(Upload&&) = delete;
  ~Upload();

  /// Appends a piece.
  /// Errors: it is no MCAP file, is beyond the limits, or cannot be written. Nothing more may be
  /// appended then.
  [[nodiscard]] Kept append(std::span<const std::uint8_t> piece);
  /// Looks at what came, waits until all is on the disk, and gives the draft its name. A recording
  /// that is cut or damaged is kept as far as it can be read.
  /// Errors: the name was taken meanwhile, nothing of it can be read as a recording, or the disk
  /// fails.
  [[nodiscard]] Result<KeptRecording, NotKept> finish();

 private:
  Upload(std::filesystem::path draft, std::filesystem::path target, std::string name,
         mcap::FileSink sink, const Limits& limits);
  [[nodiscard]] Kept look_for_room();
  [[nodiscard]] Result<KeptRecording, NotKept> look_into() const;

  std::filesystem::path draft_, target_;
  std::string name_;
  std::unique_ptr<mcap::FileSink> sink_;  ///< null after the end
  Limits limits_;
  std::uint64_t written_ = 0, looked_at_ = 0;
  std::vector<std::uint8_t> begin_;  ///< the first bytes
};

/// Removes the drafts that a monitor left behind when it was killed.
void remove_abandoned_uploads(const RecordingFolder& folder);

}  // namespace galilean::monitor
