// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/record/losses.h"
#include "monitor/record/recording_files.h"

namespace galilean::monitor {

/// Returns what was recorded, on one line: "run.mcap: 17 messages of 3 topics in 2.0 s, 0.1 MB".
[[nodiscard]] std::string recording_text(const std::string& name,
                                         const RecordingFiles::Totals& totals, std::size_t topics);

/// Why a recording has no message.
enum class Emptiness {
  kNobodyHeard,  ///< nobody writes a topic
  kAllLeftOut,   ///< the selection takes none of the topics
  kAllSilent     ///< nobody who writes a topic has sent anything
};
/// Returns the sentence for it, with what to do.
[[nodiscard]] std::string emptiness_text(Emptiness why);

/// Returns what did not come of one writer, each under the reason for which it was counted, as
/// "5 lost because the recorder was too slow, 3 sent before it listened". Says nothing of a reason
/// for which nothing was counted.
[[nodiscard]] std::string losses_text(const WriterLosses& losses);

/// Returns a sentence for each writer of which messages are missing.
[[nodiscard]] std::vector<std::string> missing_text(const std::vector<WriterLosses>& losses);

}  // namespace galilean::monitor
