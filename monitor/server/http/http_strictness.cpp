// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_strictness.h"

#include <boost/beast/core/string.hpp>
#include <boost/beast/http/field.hpp>
#include <iterator>

namespace galilean::monitor {

namespace http = boost::beast::http;

std::optional<std::size_t> head_size(std::string_view text) {
  constexpr std::string_view kEmptyLine = "\r\n\r\n";
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\n' && (at == 0 || text[at - 1] != '\r')) return at + 1;
    if (text.substr(at, kEmptyLine.size()) == kEmptyLine) return at + kEmptyLine.size();
  }
  return std::nullopt;
}

std::optional<MalformedHead> malformed_lines(std::string_view head) {
  for (std::size_t at = 0; at < head.size(); ++at) {
    if (head[at] == '\0') return MalformedHead{400, "A request's head has no zero bytes."};
    const bool ends_line = head.substr(at, 2) == "\r\n";
    if (!ends_line && (head[at] == '\r' || head[at] == '\n'))
      return MalformedHead{400, "Each line of a request's head ends with CR and LF."};
    if (!ends_line) continue;
    ++at;
    const auto next = head.substr(at + 1, 1);
    if (next == " " || next == "\t")
      return MalformedHead{400, "A field of a request's head stands on one line."};
  }
  return std::nullopt;
}

std::optional<MalformedHead> malformed_fields(const http::request_header<>& head,
                                              std::size_t most_fields) {
  const auto fields = static_cast<std::size_t>(std::distance(head.begin(), head.end()));
  if (fields > most_fields)
    return MalformedHead{431, "A request has at most " + std::to_string(most_fields) + " fields."};
  const auto hosts = head.count(http::field::host);
  if (hosts > 1 || (hosts == 0 && head.version() == 11))
    return MalformedHead{400, "A request names one Host."};
  const auto encodings = head.count(http::field::transfer_encoding);
  if (encodings == 0) return std::nullopt;
  if (head.version() != 11) return MalformedHead{400, "Transfer-Encoding is for HTTP/1.1."};
  if (head.count(http::field::content_length) > 0)
    return MalformedHead{400, "A request has either Content-Length or Transfer-Encoding."};
  const auto coding = head[http::field::transfer_encoding];
  if (encodings > 1 || !boost::beast::iequals(coding, "chunked"))
    return MalformedHead{501, "The only Transfer-Encoding that this server knows is chunked."};
  return std::nullopt;
}

}  // namespace galilean::monitor
