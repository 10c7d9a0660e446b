// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/losses.h"

namespace galilean::monitor {

/// What a file tells of what it lacks. Of a recording in several files, it is what the file lacks
/// from the end of the file before.
struct ToldLosses {
  std::vector<WriterLosses> writers;  ///< those of which something came late or did not come
  /// Whether it was told at the recording's end. Otherwise the recorder did not end in order, and
  /// more may have been lost. It is false for a copy that may lack more than it tells, too.
  bool is_whole = false;
  /// What a copy lacks of the files that it was made from.
  std::vector<CopyLosses> copies = {};

  /// Returns how many messages are missing in all, as far as is known.
  [[nodiscard]] std::uint64_t missing() const noexcept;
};

/// Returns whether the recorder told everything at its end; of files that were merged, each
/// recorder.
[[nodiscard]] bool tells_its_end(const mcap::Summary& summary);

/// Returns what the recording tells. Nothing: a program made it that counts no losses, and it is no
/// copy that lacks anything.
[[nodiscard]] std::optional<ToldLosses> told_losses(const mcap::ByteSource& source,
                                                    const mcap::Summary& summary);

/// Returns how many messages of each topic are missing by what recorders told, by the topics' names
/// as `visible` gives them; nothing: they could not be counted. Topics of which nothing was told
/// are among them only if all was told.
[[nodiscard]] std::map<std::string, std::optional<std::uint64_t>> missing_by_topic(
    const ToldLosses& losses, const mcap::Summary& summary);

}  // namespace galilean::monitor
