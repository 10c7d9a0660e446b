// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <boost/asio/write.hpp>
#include <utility>

#include "monitor/server/http/http_connection.h"

namespace galilean::monitor {
namespace {

/// Returns whether an answer of this status has a body, and so a length (RFC 9110, 8.6).
bool has_body(int status) {
  return status >= 200 && status != 204 && status != 304;
}

/// How long a client may go on with a body that was refused.
constexpr auto kLongestRest = std::chrono::seconds(10);

}  // namespace

void HttpConnection::respond(HttpResponse response) {
  awaits_answer_ = false;
  // What is left of the request's body would be taken for the next request. Of one that was refused
  // before it was read, an unknown rest is left.
  const bool is_read = parser_ ? parser_->is_done() : false;
  leaves_body_ = stream_parser_ ? !stream_parser_->is_done() : !is_read;
  if (leaves_body_) keep_alive_ = false;
  outgoing_ = std::move(response.stream);
  body_ = response.body ? std::move(response.body) : std::make_shared<const std::string>();
  write_head(response);
  const bool with_body = !head_only_ && has_body(response.status);
  stream_.expires_after(kLongestRequest);
  // Head and body are written without a copy, mostly in one system call. Beast's serializer would
  // take longer than that call.
  const std::array<boost::asio::const_buffer, 2> parts{
      boost::asio::buffer(head_),
      with_body ? boost::asio::buffer(*body_) : boost::asio::const_buffer()};
  boost::asio::async_write(stream_, parts,
                           [self = shared_from_this()](error_code error, std::size_t) {
                             if (!error) self->send_piece();
                           });
}

void HttpConnection::write_head(const HttpResponse& response) {
  const auto status = static_cast<boost::beast::http::status>(response.status);
  head_ = version_ == 11 ? "HTTP/1.1 " : "HTTP/1.0 ";
  head_.append(std::to_string(response.status)).append(" ");
  head_.append(boost::beast::http::obsolete_reason(status)).append("\r\n");
  write_field("Server", "galilean");
  write_field("X-Content-Type-Options", "nosniff");
  if (!allowed_origin_.empty()) write_field("Access-Control-Allow-Origin", allowed_origin_);
  if (!response.content_type.empty()) write_field("Content-Type", response.content_type);
  for (const auto& [name, value] : response.headers) write_field(name, value);
  if (keep_alive_ != (version_ == 11))
    write_field("Connection", keep_alive_ ? "keep-alive" : "close");
  if (has_body(response.status))
    write_field("Content-Length", std::to_string(outgoing_ ? outgoing_->bytes : body_->size()));
  head_.append("\r\n");
}

void HttpConnection::write_field(std::string_view name, std::string_view value) {
  head_.append(name).append(": ").append(value).append("\r\n");
}

void HttpConnection::go_on() {
  outgoing_.reset();
  stream_parser_.reset();
  parser_.reset();
  let_body_go();
  piece_ = {};
  if (keep_alive_) return read();
  error_code ignored;
  stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  if (!leaves_body_) return;
  wait_for_others();
  stream_.expires_after(kLongestRest);
  pass_over_rest();
}

}  // namespace galilean::monitor
