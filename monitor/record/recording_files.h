// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "core/clock.h"
#include "core/result.h"
#include "monitor/mcap/byte_sink.h"
#include "monitor/mcap/mcap_writer.h"

namespace galilean::monitor {

/// Where a recording goes, and when it goes on in another file.
struct FilePlan {
  std::string out;                ///< such as "run.mcap"; of several files "run_0.mcap" is the first
  bool replace = false;           ///< whether files that are there may be emptied
  std::uint64_t split_bytes = 0;  ///< a file ends when it has so many; 0: never
  Duration split_span{};          ///< or when it is so long, in log time; 0: never
  std::size_t most_files = 0;     ///< the oldest are deleted when there are more; 0: none is
  std::string library;            ///< who writes, as MCAP's header tells
};

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

  /// Begins the next file. Requires: none is open. Errors: it cannot be written.
  [[nodiscard]] Result<void> begin(std::int64_t now_ns);
  /// Ends the open file, if there is one. Errors: it cannot be written.
  [[nodiscard]] Result<void> end();

  [[nodiscard]] bool is_open() const noexcept { return file_ != nullptr; }
  /// Returns whether the open file has grown as long or as large as the plan allows.
  [[nodiscard]] bool is_full(std::int64_t now_ns) const noexcept;
  /// Requires: a file is open.
  [[nodiscard]] mcap::Writer& writer() noexcept { return file_->writer; }
  /// Returns what was written, into the open file, too.
  [[nodiscard]] Totals totals() const noexcept;
  /// Returns how users know the recording: its file, or the first and the last of several.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] const FilePlan& plan() const noexcept { return plan_; }

 private:
  struct File {
    File(std::string of_path, mcap::FileSink of_sink, const std::string& library)
        : path(std::move(of_path)), sink(std::move(of_sink)), writer(sink, {.library = library}) {}

    std::string path;
    mcap::FileSink sink;
    mcap::Writer writer;
    std::int64_t began_ns = 0;
  };

  [[nodiscard]] bool is_split() const noexcept {
    return plan_.split_bytes > 0 || plan_.split_span > Duration{};
  }
  [[nodiscard]] std::string path_of(std::size_t number) const;
  void delete_oldest();

  FilePlan plan_;
  std::unique_ptr<File> file_;
  std::deque<std::string> kept_;  ///< paths, the oldest first
  Totals ended_;                  ///< of the files that are not open
};

/// Adds what a file holds to what those before it hold.
void add(RecordingFiles::Totals& totals, const mcap::Writer& writer) noexcept;

}  // namespace galilean::monitor
