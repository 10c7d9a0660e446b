// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "core/clock.h"
#include "core/result.h"
#include "monitor/mcap/byte_sink.h"
#include "monitor/mcap/mcap_writer.h"

namespace galilean::monitor {

/// Where a recording goes, and when it goes on in another file.
struct FilePlan {
  /// Such as "run.mcap". The first of several files is "run_0.mcap". kStandardOutput is no file.
  std::string out;
  bool replace = false;           ///< whether files that are there may be emptied
  std::uint64_t split_bytes = 0;  ///< a file ends when it has so many; 0: never
  Duration split_span{};          ///< or when it is so old; 0: never
  std::size_t most_files = 0;     ///< the oldest are deleted when there are more; 0: none is
  mcap::Compression compression = mcap::Compression::kFast;
  std::string library;  ///< who writes, as MCAP's header tells
};
inline constexpr const char* kStandardOutput = "-";

/// The files of a recording, of which each can be read alone. One is open, or none while there is
/// no room for it.
class RecordingFiles {
 public:
  struct Totals {
    std::uint64_t messages = 0, bytes = 0;
    std::uint64_t start_ns = 0, end_ns = 0;  ///< log time of the first and the last message
    std::size_t files = 0;                   ///< those that were deleted, too
  };

  explicit RecordingFiles(FilePlan plan) : plan_(std::move(plan)) {}

  /// Begins the next file, and deletes the oldest if there are too many. A later file leaves those
  /// alone that are there already, and takes the next number that is free.
  /// Requires: none is open. Errors: it cannot be written.
  [[nodiscard]] Result<void> begin(Time now);
  /// Ends the open file, if there is one. Errors: it cannot be written.
  [[nodiscard]] Result<void> end();
  /// Ends the open file as `end` does, and lets `amend` add to it until the next one begins.
  /// Requires: one is open. Errors: it cannot be written.
  [[nodiscard]] Result<void> set_aside();
  /// Returns whether a file was set aside.
  [[nodiscard]] bool can_amend() const noexcept { return aside_ != nullptr; }
  /// Adds metadata to the file that was set aside. Requires: there is one. Errors: it cannot be
  /// written; without room it is as it was.
  [[nodiscard]] Result<void> amend(const mcap::Metadata& metadata);

  /// Looks whether the file that is open, or set aside, is still there. Errors: it was deleted or
  /// spoilt, and what was written to it is lost.
  [[nodiscard]] Result<void> check();
  /// Returns whether `check`, `end` or `amend` has found a file deleted or spoilt.
  [[nodiscard]] bool is_lost() const noexcept { return lost_; }
  /// Returns whether the file that is open, or set aside, stands under another name.
  [[nodiscard]] bool has_moved() const;

  [[nodiscard]] bool is_open() const noexcept { return file_ != nullptr; }
  /// Returns whether the open file has grown as old or as large as the plan allows.
  [[nodiscard]] bool is_full(Time now) const noexcept;
  /// Requires: a file is open.
  [[nodiscard]] mcap::Writer& writer() noexcept { return file_->writer; }
  /// Returns what was written, into the open file, too.
  [[nodiscard]] Totals totals() const noexcept;
  /// Returns the path of the file that was begun last. Requires: one was.
  [[nodiscard]] const std::string& newest() const noexcept { return kept_.back(); }
  /// Returns how users know the recording: its file, or the first and the last of those that are
  /// left.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] const FilePlan& plan() const noexcept { return plan_; }

 private:
  struct File {
    File(mcap::FileSink of_sink, const FilePlan& plan)
        : sink(std::move(of_sink)),
          writer(sink, {.library = plan.library, .compression = plan.compression}) {}

    mcap::FileSink sink;
    mcap::Writer writer;
    Time began{};
  };

  [[nodiscard]] std::string path_of(std::size_t number) const;
  /// Returns the path of the file to begin.
  std::string take_path();
  void delete_oldest();
  [[nodiscard]] Result<void> finish(File& file);
  [[nodiscard]] const File* newest_file() const noexcept {
    return file_ ? file_.get() : aside_.get();
  }

  FilePlan plan_;
  std::unique_ptr<File> file_;   ///< the open one
  std::unique_ptr<File> aside_;  ///< the one that has ended, and may be added to
  bool lost_ = false;
  std::size_t next_ = 0;          ///< the number of the file to begin
  std::deque<std::string> kept_;  ///< paths, the oldest first
  Totals ended_;                  ///< of the files that are not open
};

}  // namespace galilean::monitor
