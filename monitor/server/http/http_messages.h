// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "monitor/access/access.h"

namespace galilean::monitor {

/// The parts of an HTTP request that the monitor uses.
struct HttpRequest {
  std::string method;
  std::string path;  ///< percent-decoded, without the query
  std::string body;
  std::string host;
  std::string origin;  ///< empty if none was sent
  std::string token;   ///< the bearer's token; empty if none was sent
  Right right = Right::kNone;
  std::string if_none_match;
  bool accepts_gzip = false;
};

struct HttpResponse {
  int status = 200;
  std::string content_type = "application/json";
  std::shared_ptr<const std::string> body;  ///< shared, so that a file in memory is not copied
  std::vector<std::pair<std::string, std::string>> headers;
};

using Respond = std::function<void(HttpResponse)>;
/// Answers a request by one call of Respond, at once or later, on the io_context's thread.
using HttpHandler = std::function<void(const HttpRequest&, Respond)>;

[[nodiscard]] HttpResponse json_response(const nlohmann::json& json, int status = 200);
[[nodiscard]] HttpResponse text_response(std::string text, std::string content_type,
                                         int status = 200);
/// Returns an error as problem+json (RFC 9457): {title, status, detail} and the members of `more`.
[[nodiscard]] HttpResponse problem(int status, const std::string& detail);
[[nodiscard]] HttpResponse problem(int status, const std::string& detail,
                                   const nlohmann::json& more);

/// Returns the answer to a request that has the right `has` and needs `needs`: 401 if it has none,
/// else 403.
[[nodiscard]] HttpResponse refusal(Right has, Right needs);

}  // namespace galilean::monitor
