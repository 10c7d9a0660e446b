// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_caching.h"

#include <algorithm>

#include "bhdl/source/sha256.h"
#include "monitor/compression/gzip.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kLarge_bytes = 1024;
constexpr int kQuick = 1;  ///< gzip's level; low, because each answer is compressed anew

bool says_how_it_may_be_kept(const HttpResponse& response) {
  return std::ranges::any_of(response.headers,
                             [](const auto& header) { return header.first == "Cache-Control"; });
}

/// Returns whether compressing is worth its time. Pictures and scenes are compressed already.
bool is_text(std::string_view content_type) {
  return content_type.starts_with("text/") || content_type.find("json") != content_type.npos ||
         content_type.find("yaml") != content_type.npos;
}

void compress(HttpResponse& response, bool accepts_gzip) {
  if (!is_text(response.content_type)) return;
  response.headers.emplace_back("Vary", "Accept-Encoding");
  if (!accepts_gzip || response.body->size() < kLarge_bytes) return;
  response.body = std::make_shared<const std::string>(gzipped(*response.body, kQuick));
  response.headers.emplace_back("Content-Encoding", "gzip");
}

}  // namespace

bool is_known(std::string_view if_none_match, std::string_view etag) {
  return if_none_match == "*" || if_none_match.find(etag) != if_none_match.npos;
}

HttpResponse with_caching_and_compression(HttpResponse response, const HttpRequest& request) {
  const bool reads = request.method == "GET" || request.method == "HEAD";
  if (response.status != 200 || !response.body || says_how_it_may_be_kept(response))
    return response;
  if (reads) {
    // The tag is weak because the bytes that are sent depend on the encoding.
    const auto etag = "W/\"" + bhdl::sha256(*response.body).substr(0, 32) + '"';
    response.headers.emplace_back("ETag", etag);
    response.headers.emplace_back("Cache-Control", "no-cache");
    if (is_known(request.if_none_match, etag)) {
      response.status = 304;
      response.body.reset();
      return response;
    }
  }
  compress(response, request.accepts_gzip);
  return response;
}

}  // namespace galilean::monitor
