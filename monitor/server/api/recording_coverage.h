// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>

#include "monitor/recordings/recording_folder.h"
#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// Reads a whole recording, in bounded memory, and returns what its robots exercised of their
/// programs, as docs/openapi.yaml describes it; or 422 if it is no recording, and 503 once `stops`
/// is true. It may take as long as the disk takes to read the file.
[[nodiscard]] HttpResponse coverage_response(const std::string& name,
                                             const OpenedRecording& recording,
                                             const std::atomic<bool>& stops);

}  // namespace galilean::monitor
