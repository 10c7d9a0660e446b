// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "monitor/mcap/mcap_reader.h"

namespace galilean::logs {

/// A recording that is open for reading, and what it holds.
class Recording {
 public:
  /// Errors: the file cannot be opened, or it is no recording. The message names the file.
  [[nodiscard]] static Result<Recording> open(const std::string& path,
                                              mcap::Depth depth = mcap::Depth::kAsNeeded);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] const mcap::ByteSource& source() const noexcept { return *file_; }
  [[nodiscard]] const mcap::Summary& summary() const noexcept { return summary_; }

  /// Returns the ids of the channels of a topic, whose leading slash may be left out.
  /// Errors: it has no such topic; the message says what may have been meant.
  [[nodiscard]] Result<std::vector<std::uint16_t>> channels_of(const std::string& topic) const;
  /// Returns the name of the only topic. Errors: there are others; the message lists them.
  [[nodiscard]] Result<std::string> only_topic() const;

 private:
  Recording(std::string path, std::unique_ptr<mcap::FileSource> file, mcap::Summary summary);

  std::string path_;
  std::unique_ptr<mcap::FileSource> file_;
  mcap::Summary summary_;
};

}  // namespace galilean::logs
