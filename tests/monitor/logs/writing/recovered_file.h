// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tests/monitor/logs/writing/sample_recording.h"

namespace galilean::logs {

/// What `galilean log recover` makes of a broken recording.
struct RecoveredFile {
  int code = -1;
  std::vector<Sample> samples;  ///< in what it wrote, if the code is not 1
};

/// Recovers a recording into another file, and reads that. Ends the process with a sentence if what
/// was recovered is not whole, or the exit code is none that is documented.
[[nodiscard]] RecoveredFile recover(const std::string& broken, const std::string& recovered);

/// Ends the process with the sentence if the promise is broken.
void promise(bool holds, const std::string& sentence);

/// Promises that the newest that was recovered is less than a second older than the newest of the
/// first `accepted` samples, and that all that was recovered is right and without a gap.
void promise_all_but_a_second(const std::vector<Sample>& recovered,
                              const std::vector<Sample>& samples, std::size_t accepted,
                              const std::string& name);

/// Promises that all that was recovered is among the samples and in their order, and that those
/// that are not lie within a second.
void promise_one_second(const std::vector<Sample>& recovered, const std::vector<Sample>& samples,
                        const std::string& name);

}  // namespace galilean::logs
