// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/background/worker.h"
#include "monitor/recordings/recording_folder.h"
#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// Puts the body of `request` into the folder as a recording of that name. The disk is used on
/// `worker`. Answers 201, or why it is not kept; a client that goes away in the middle gets no
/// answer, and nothing of it is kept.
/// Requires: the request has a body_stream; `folder` and `worker` outlive the connection.
void receive_recording(const RecordingFolder& folder, Worker& worker, const std::string& name,
                       const HttpRequest& request, const Respond& respond);

}  // namespace galilean::monitor
