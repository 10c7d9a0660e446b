// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "monitor/server/http/http_connection.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kPieceBytes = 256 << 10;

}  // namespace

void HttpConnection::next(Take take) {
  if (std::exchange(awaits_continue_, false)) return say_continue(std::move(take));
  if (stream_parser_->is_done()) {
    boost::asio::post(stream_.get_executor(),
                      [take = std::move(take)] { take(std::span<const std::uint8_t>()); });
    return;
  }
  piece_.resize(kPieceBytes);
  stream_parser_->get().body().data = piece_.data();
  stream_parser_->get().body().size = piece_.size();
  stream_.expires_after(kLongestRequest);
  boost::beast::http::async_read_some(
      stream_, buffer_, *stream_parser_,
      [self = shared_from_this(), take = std::move(take)](error_code error, std::size_t) {
        self->take_piece(error, take);
      });
}

/// A client that asks first sends its body only after this.
void HttpConnection::say_continue(Take take) {
  static constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
  stream_.expires_after(kLongestRequest);
  boost::asio::async_write(
      stream_, boost::asio::buffer(kContinue),
      [self = shared_from_this(), take = std::move(take)](error_code error, std::size_t) {
        if (error) return take(Error{error.message()});
        self->next(take);
      });
}

void HttpConnection::take_piece(error_code error, const Take& take) {
  if (error == boost::beast::http::error::need_buffer) error = {};
  if (error) {
    keep_alive_ = false;
    return take(Error{error.message()});
  }
  if (is_withdrawn()) {
    keep_alive_ = false;
    return take(Error{"the token was revoked or has expired"});
  }
  stream_.expires_never();
  const auto size = piece_.size() - stream_parser_->get().body().size;
  if (size == 0) return next(take);
  take(std::span<const std::uint8_t>(piece_).first(size));
}

/// Sends the next piece of a streamed body, or goes on behind the last.
void HttpConnection::send_piece() {
  if (!outgoing_ || outgoing_->bytes == 0 || head_only_) return go_on();
  if (is_withdrawn()) return close();
  // Where the file has become shorter, the head has promised more than there is. Only the
  // connection's end can tell that.
  context_->transfers.run([self = shared_from_this()] { return self->read_piece(); },
                          [self = shared_from_this()](bool is_read) {
                            if (is_read) return self->write_piece();
                            self->close();
                          },
                          [self = shared_from_this()](const std::string&) { self->close(); });
}

/// Runs on the thread that may block. Nothing else touches the piece meanwhile.
bool HttpConnection::read_piece() {
  piece_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kPieceBytes, outgoing_->bytes)));
  return outgoing_->read(outgoing_->offset, piece_);
}

void HttpConnection::write_piece() {
  outgoing_->offset += piece_.size();
  outgoing_->bytes -= piece_.size();
  stream_.expires_after(kLongestRequest);
  boost::asio::async_write(stream_, boost::asio::buffer(piece_),
                           [self = shared_from_this()](error_code error, std::size_t) {
                             if (!error) self->send_piece();
                           });
}

void HttpConnection::close() {
  error_code ignored;
  stream_.socket().close(ignored);
}

/// Reads what a client still sends: to close now would take the answer away from it.
void HttpConnection::pass_over_rest() {
  piece_.resize(kPieceBytes);
  stream_.async_read_some(boost::asio::buffer(piece_),
                          [self = shared_from_this()](error_code error, std::size_t) {
                            if (!error) self->pass_over_rest();
                          });
}

}  // namespace galilean::monitor
