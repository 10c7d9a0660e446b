// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <mutex>
#include <ostream>
#include <streambuf>
#include <string_view>

namespace galilean {

/// Has a stream, such as std::clog, write whole lines to a file descriptor and never wait. A pipe
/// that nobody reads, or a terminal that was stopped by Ctrl-S, would otherwise stop each thread
/// that has something to say. Lines for which there is no room are dropped, and the next line that
/// has room says how many. Any thread may write to the stream.
class NonBlockingLog final : public std::streambuf {
 public:
  /// A longer line is cut, since only so much is written at once or not at all.
  static constexpr std::size_t kMostLineBytes = 4096;

  /// `stream` gets its buffer back with the end of this. Requires: both outlive this, and no thread
  /// writes to `stream` meanwhile.
  NonBlockingLog(int descriptor, std::ostream& stream);
  ~NonBlockingLog() override;
  NonBlockingLog(const NonBlockingLog&) = delete;
  NonBlockingLog& operator=(const NonBlockingLog&) = delete;

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;

 private:
  void add(const char* text, std::size_t count);
  void write_line(std::string_view line);
  [[nodiscard]] bool write_whole(std::string_view text) const;

  int descriptor_;
  std::ostream& stream_;
  std::streambuf* before_;
  std::mutex mutex_;  ///< of what is written, and of `dropped_`
  std::size_t dropped_ = 0;
};

}  // namespace galilean
