// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/record/pause_log.h"
#include "monitor/record/told_losses.h"

namespace galilean::monitor {

/// Returns the time from the first message to the last, without the silences [s].
[[nodiscard]] double duration_s(const mcap::Summary& summary);
/// Returns the names of the compressions, such as "zstd" or "lz4, none".
[[nodiscard]] std::string compression_text(const mcap::Summary& summary);
/// Returns a description of the file for people, with a line for each channel, one for each writer
/// of which something did not come, and one for each pause.
[[nodiscard]] std::string describe(const std::string& path, const mcap::Summary& summary,
                                   const std::optional<ToldLosses>& losses,
                                   const std::vector<Pause>& pauses = {});
/// Returns the same description as JSON, for programs.
[[nodiscard]] std::string describe_json(const std::string& path, const mcap::Summary& summary,
                                        const std::optional<ToldLosses>& losses,
                                        const std::vector<Pause>& pauses = {});

}  // namespace galilean::monitor
