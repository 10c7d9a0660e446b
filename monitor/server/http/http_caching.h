// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// Returns whether If-None-Match names `etag` or is `*` (RFC 9110, 13.1.2).
[[nodiscard]] bool is_known(std::string_view if_none_match, std::string_view etag);

/// Returns `response` with an ETag, as 304 without a body if the client has that body already, and
/// compressed if it is a large text and the client takes gzip. Leaves a response as it is if its
/// status is not 200 or it has a Cache-Control field already.
[[nodiscard]] HttpResponse with_caching_and_compression(HttpResponse response,
                                                        const HttpRequest& request);

}  // namespace galilean::monitor
