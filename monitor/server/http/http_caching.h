// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// Returns whether If-None-Match names `etag` or is `*` (RFC 9110, 13.1.2).
[[nodiscard]] bool is_known(std::string_view if_none_match, std::string_view etag);

/// What a client has already is not sent again, and what is large goes compressed: an answer that
/// says how it may be kept is left as it is.
[[nodiscard]] HttpResponse spared(HttpResponse response, const HttpRequest& request);

}  // namespace galilean::monitor
