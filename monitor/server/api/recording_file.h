// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/recordings/recording_folder.h"
#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// Returns the answer to a request for a recording's file, or for a part of it. The bytes are read
/// while they are sent.
[[nodiscard]] HttpResponse recording_response(const OpenedRecording& recording,
                                              const HttpRequest& request);
/// Returns the answer if it cannot be opened: 403, 404 or 503.
[[nodiscard]] HttpResponse recording_problem(const NotOpened& why);

}  // namespace galilean::monitor
