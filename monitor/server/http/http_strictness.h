// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/beast/http/message.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace galilean::monitor {

/// Why a request's head is refused, after which the connection closes: nobody knows where the next
/// request begins.
struct MalformedHead {
  int status = 400;
  std::string why;  ///< one sentence
};

/// Returns how long the head is with which `text` begins, the empty line included; nothing while
/// that has not come. A line that does not end with CR and LF ends the head, because no head has
/// one.
[[nodiscard]] std::optional<std::size_t> head_size(std::string_view text);

/// Looks at a head as it came, with the empty line behind it. What a proxy and this server might
/// read differently is refused: a field that goes on in the next line, and an end of line that is
/// not CRLF (RFC 9112, 2.2 and 5.2).
[[nodiscard]] std::optional<MalformedHead> malformed_lines(std::string_view head);

/// Looks at the fields of a head. In HTTP/1.1 there is one Host. Transfer-Encoding is "chunked" or
/// absent, and not beside Content-Length (RFC 9112, 3.2 and 6). There are at most `most_fields`.
[[nodiscard]] std::optional<MalformedHead> malformed_fields(
    const boost::beast::http::request_header<>& head, std::size_t most_fields);

}  // namespace galilean::monitor
