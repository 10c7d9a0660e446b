// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "monitor/access/access.h"
#include "monitor/access/operator_id.h"

namespace galilean::monitor {

/// The body of a request that is too large to be kept. It is read piece by piece, so that a client
/// does not send faster than its pieces are used. For use on the io_context's thread.
class IncomingBody {
 public:
  /// Takes a piece, which is valid until the next call of `next`; an empty one after the last.
  /// Errors: the client went away, or sent nothing for too long.
  using Take = std::function<void(Result<std::span<const std::uint8_t>>)>;

  virtual ~IncomingBody() = default;
  /// Reads the next piece, and calls `take` later.
  /// Requires: no other piece is being read.
  virtual void next(Take take) = 0;
};

/// A part of a file that is read while it is sent. `read` is called on a thread that may block, and
/// returns false if the bytes are not there any more: then the connection ends.
struct StreamedBody {
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
  std::function<bool(std::uint64_t offset, std::span<std::uint8_t> to)> read;
};

/// The parts of an HTTP request that the monitor uses.
struct HttpRequest {
  std::string method;
  std::string path;  ///< percent-decoded, without the query
  std::string body;
  std::string host;
  std::string origin;  ///< empty if none was sent
  std::string token;   ///< the bearer's token; empty if none was sent
  Right right = Right::kNone;
  /// What the sender says of itself: X-Galilean-Operator, and X-Galilean-Client, which names its
  /// tab or process. Empty if it was not sent.
  std::string operator_name, client;
  OperatorId who;  ///< the sender, as the monitor calls it
  std::string if_none_match;
  bool accepts_gzip = false;
  std::string range, if_range;                ///< empty if none was sent
  std::optional<std::uint64_t> body_bytes;    ///< as the client announces it
  std::shared_ptr<IncomingBody> body_stream;  ///< in place of `body` where the method is PUT
};

struct HttpResponse {
  int status = 200;
  std::string content_type = "application/json";
  std::shared_ptr<const std::string> body;  ///< shared, so that a file in memory is not copied
  std::vector<std::pair<std::string, std::string>> headers;
  std::optional<StreamedBody> stream = {};  ///< in place of `body`
};

using Respond = std::function<void(HttpResponse)>;
/// Answers a request by one call of Respond, at once or later, on the io_context's thread.
using HttpHandler = std::function<void(const HttpRequest&, Respond)>;

[[nodiscard]] HttpResponse json_response(const nlohmann::json& json, int status = 200);
[[nodiscard]] HttpResponse text_response(std::string text, std::string content_type,
                                         int status = 200);
/// Returns an error as problem+json (RFC 9457): {title, status, detail} and the members of `more`.
/// A 503 says in Retry-After when to ask again.
[[nodiscard]] HttpResponse problem(int status, const std::string& detail);
[[nodiscard]] HttpResponse problem(int status, const std::string& detail,
                                   const nlohmann::json& more);

/// Returns the answer to a request that has the right `has` and needs `needs`: 401 if it has none,
/// else 403.
[[nodiscard]] HttpResponse refusal(Right has, Right needs);

}  // namespace galilean::monitor
