// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_session.h"

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "monitor/background/guarded.h"
#include "monitor/server/http/websocket_session.h"
#include "monitor/server/text/url_text.h"

namespace galilean::monitor {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using error_code = boost::system::error_code;

constexpr std::uint32_t kMostHeaderBytes = 16 << 10;
constexpr std::uint64_t kMostBodyBytes = 16 << 20;
constexpr std::size_t kPieceBytes = 256 << 10;  ///< of bodies that are read and sent in pieces
constexpr auto kLongestRequest = std::chrono::seconds(30);
constexpr auto kLongestRest = std::chrono::seconds(10);

/// Returns the bearer's token, else `token` of the query. A browser cannot send a bearer's token
/// with a WebSocket, so it names the token there: ?token=…
std::string token_of(std::string_view authorization, std::string_view target) {
  constexpr std::string_view kBearer = "Bearer ";
  if (authorization.starts_with(kBearer)) return std::string(authorization.substr(kBearer.size()));
  return query_value(target, "token");
}

HttpRequest plain(const http::request_header<>& from) {
  HttpRequest request;
  request.method = from.method_string();
  const std::string_view target(from.target().data(), from.target().size());
  request.path = percent_decoded(target.substr(0, target.find('?')));
  const auto authorization = from[http::field::authorization];
  request.token = token_of({authorization.data(), authorization.size()}, target);
  request.host = from[http::field::host];
  request.origin = from[http::field::origin];
  request.if_none_match = from[http::field::if_none_match];
  request.accepts_gzip =
      from[http::field::accept_encoding].find("gzip") != beast::string_view::npos;
  request.range = from[http::field::range];
  request.if_range = from[http::field::if_range];
  return request;
}

/// Serves one connection. Where the method is PUT it gives the body away piece by piece.
class HttpSession final : public IncomingBody, public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(boost::asio::ip::tcp::socket socket,
              std::shared_ptr<HttpServer::ServerContext> context)
      : stream_(std::move(socket)), context_(std::move(context)) {
    ++context_->counts.connections;
    error_code ignored;
    stream_.socket().set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  }
  ~HttpSession() override { --context_->counts.connections; }

  void read() {
    head_parser_.emplace();
    head_parser_->header_limit(kMostHeaderBytes);
    head_parser_->body_limit(boost::none);  // each kind of body has a limit of its own
    stream_.expires_after(kLongestRequest);
    http::async_read_header(stream_, buffer_, *head_parser_,
                            [self = shared_from_this()](error_code error, std::size_t) {
                              if (error) return self->fail(error);
                              self->attempt([&] { self->read_body(); });
                            });
  }

  void next(Take take) override {
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
    http::async_read_some(stream_, buffer_, *stream_parser_,
                          [self = shared_from_this(), take = std::move(take)](
                              error_code error, std::size_t) { self->take_piece(error, take); });
  }

 private:
  void fail(error_code error) {
    keep_alive_ = false;
    version_ = 11;
    if (error == http::error::body_limit)
      respond(problem(413, "The request's body is larger than 16 MB."));
    else if (error == http::error::header_limit)
      respond(problem(431, "The request's header is larger than 16 kB."));
    else if (error.category() == make_error_code(http::error::bad_method).category() &&
             error != http::error::end_of_stream && error != http::error::partial_message)
      respond(problem(400, "This is not HTTP: " + error.message() + "."));
  }

  template <class Work>
  void attempt(Work work) {
    const auto done = guarded("a request", work);
    if (!done) respond_internal_error(done.error().message);
  }

  void read_body() {
    awaits_answer_ = true;
    if (head_parser_->get().method() == http::verb::put) return receive_in_pieces();
    if (head_parser_->content_length().value_or(0) > kMostBodyBytes)
      return fail(http::error::body_limit);
    parser_.emplace(std::move(*head_parser_));
    parser_->body_limit(kMostBodyBytes);
    if (parser_->is_done()) return receive();
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                       if (error) return self->fail(error);
                       self->attempt([&] { self->receive(); });
                     });
  }

  void receive() {
    auto message = parser_->release();
    auto request = begin(message);
    if (!request) return;
    const auto& path = request->path;
    if (beast::websocket::is_upgrade(message) &&
        (path == "/ws" || path == "/lsp" || path == "/replay")) {
      if (request->right == Right::kNone) return respond(refusal(Right::kNone, Right::kRead));
      if (path == "/lsp") return become_language_server(message);
      if (path == "/replay") return become_replay(message);
      return become_websocket(message, request->right);
    }
    request->body = std::move(message.body());
    handle(*request);
  }

  void receive_in_pieces() {
    const auto length = head_parser_->content_length();
    stream_parser_.emplace(std::move(*head_parser_));
    stream_parser_->body_limit(boost::none);
    const auto expected = stream_parser_->get()[http::field::expect];
    awaits_continue_ = beast::iequals(expected, "100-continue");
    auto request = begin(stream_parser_->get());
    if (!request) return;
    if (length) request->body_bytes = *length;
    request->body_stream = shared_from_this();
    handle(*request);
  }

  /// Takes a message's head. Returns nothing if the guard refused it, which is answered.
  template <class Body>
  std::optional<HttpRequest> begin(const http::request<Body>& message) {
    version_ = message.version();
    keep_alive_ = message.keep_alive();
    head_only_ = message.method() == http::verb::head;
    auto request = plain(message.base());
    ++context_->counts.requests;
    allowed_origin_ = origin_for(request);
    if (const auto admitted = context_->guard.admit(request); !admitted) {
      ++context_->counts.refused;
      respond(problem(403, admitted.error().message));
      return {};
    }
    request.right = context_->guard.is_of_stranger(request)
                        ? context_->access.right_by_token(request.token)
                        : context_->access.right_of(request.token);
    return request;
  }

  [[nodiscard]] std::string origin_for(const HttpRequest& request) const {
    if (request.path.starts_with(Guard::kSharedPath)) return "*";
    return context_->guard.is_allowed_origin(request.origin) ? request.origin : std::string();
  }

  void handle(const HttpRequest& request) {
    stream_.expires_never();
    context_->handler(request,
                      [self = shared_from_this(), number = ++handled_](HttpResponse response) {
                        // Only the first answer to a request is sent.
                        if (self->awaits_answer_ && self->handled_ == number)
                          self->respond(std::move(response));
                      });
  }

  void respond_internal_error(const std::string& failure) {
    if (awaits_answer_)
      respond(problem(500, "The monitor failed at this request: " + failure + "."));
  }

  void become_websocket(const http::request<http::string_body>& message, Right right) {
    stream_.expires_never();
    serve_websocket(stream_.release_socket(), message, context_->hub, context_->rounds, right);
  }

  void become_language_server(const http::request<http::string_body>& message) {
    stream_.expires_never();
    serve_language(stream_.release_socket(), message, context_->rounds, context_->language);
  }

  void become_replay(const http::request<http::string_body>& message) {
    stream_.expires_never();
    serve_replay(stream_.release_socket(), message, context_->rounds, context_->replay);
  }

  /// A client that asks first sends its body only after this.
  void say_continue(Take take) {
    static constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
    stream_.expires_after(kLongestRequest);
    boost::asio::async_write(
        stream_, boost::asio::buffer(kContinue),
        [self = shared_from_this(), take = std::move(take)](error_code error, std::size_t) {
          if (error) return take(Error{error.message()});
          self->next(take);
        });
  }

  void take_piece(error_code error, const Take& take) {
    if (error == http::error::need_buffer) error = {};
    if (error) {
      keep_alive_ = false;
      return take(Error{error.message()});
    }
    stream_.expires_never();
    const auto size = piece_.size() - stream_parser_->get().body().size;
    if (size == 0) return next(take);
    take(std::span<const std::uint8_t>(piece_).first(size));
  }

  void respond(HttpResponse response) {
    awaits_answer_ = false;
    // What is left of the request's body would be taken for the next request.
    leaves_body_ = stream_parser_ && !stream_parser_->is_done();
    if (leaves_body_) keep_alive_ = false;
    outgoing_ = std::move(response.stream);
    body_ = response.body ? std::move(response.body) : std::make_shared<const std::string>();
    write_head(response);
    const bool with_body = !head_only_ && response.status != 304;
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

  /// Sends the next piece of a streamed body, or goes on behind the last.
  void send_piece() {
    if (!outgoing_ || outgoing_->bytes == 0 || head_only_) return go_on();
    context_->transfers.run([self = shared_from_this()] { return self->read_piece(); },
                            [self = shared_from_this()](bool is_read) {
                              // The head has promised more than there is: only the connection's end
                              // can tell that.
                              if (is_read) return self->write_piece();
                              self->close();
                            },
                            [self = shared_from_this()](const std::string&) { self->close(); });
  }

  /// Runs on the thread that may block. Nothing else touches the piece meanwhile.
  [[nodiscard]] bool read_piece() {
    piece_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kPieceBytes, outgoing_->bytes)));
    return outgoing_->read(outgoing_->offset, piece_);
  }

  void write_piece() {
    outgoing_->offset += piece_.size();
    outgoing_->bytes -= piece_.size();
    stream_.expires_after(kLongestRequest);
    boost::asio::async_write(stream_, boost::asio::buffer(piece_),
                             [self = shared_from_this()](error_code error, std::size_t) {
                               if (!error) self->send_piece();
                             });
  }

  void close() {
    error_code ignored;
    stream_.socket().close(ignored);
  }

  void write_head(const HttpResponse& response) {
    const auto status = static_cast<http::status>(response.status);
    head_ = version_ == 11 ? "HTTP/1.1 " : "HTTP/1.0 ";
    head_.append(std::to_string(response.status)).append(" ");
    head_.append(http::obsolete_reason(status)).append("\r\n");
    write_field("Server", "galilean");
    write_field("X-Content-Type-Options", "nosniff");
    if (!allowed_origin_.empty()) write_field("Access-Control-Allow-Origin", allowed_origin_);
    if (!response.content_type.empty()) write_field("Content-Type", response.content_type);
    for (const auto& [name, value] : response.headers) write_field(name, value);
    if (keep_alive_ != (version_ == 11))
      write_field("Connection", keep_alive_ ? "keep-alive" : "close");
    if (response.status != 304)
      write_field("Content-Length", std::to_string(outgoing_ ? outgoing_->bytes : body_->size()));
    head_.append("\r\n");
  }

  void write_field(std::string_view name, std::string_view value) {
    head_.append(name).append(": ").append(value).append("\r\n");
  }

  void go_on() {
    outgoing_.reset();
    stream_parser_.reset();
    piece_ = {};
    if (keep_alive_) return read();
    error_code ignored;
    stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
    if (!leaves_body_) return;
    stream_.expires_after(kLongestRest);
    piece_.resize(kPieceBytes);
    pass_over_rest();
  }

  /// Reads what a client still sends: to close now would take the answer away from it.
  void pass_over_rest() {
    stream_.async_read_some(boost::asio::buffer(piece_),
                            [self = shared_from_this()](error_code error, std::size_t) {
                              if (!error) self->pass_over_rest();
                            });
  }

  beast::tcp_stream stream_;
  std::shared_ptr<HttpServer::ServerContext> context_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::empty_body>> head_parser_;
  std::optional<http::request_parser<http::string_body>> parser_;
  std::optional<http::request_parser<http::buffer_body>> stream_parser_;
  std::optional<StreamedBody> outgoing_;
  std::vector<std::uint8_t> piece_;
  std::shared_ptr<const std::string> body_;
  std::string head_;
  std::string allowed_origin_;
  unsigned version_ = 11;
  std::uint64_t handled_ = 0;  ///< requests that the handler got
  bool awaits_answer_ = false;
  bool awaits_continue_ = false;
  bool leaves_body_ = false;  ///< whether a part of the request's body was not read
  bool keep_alive_ = false;
  bool head_only_ = false;
};

}  // namespace

void serve_http(boost::asio::ip::tcp::socket socket,
                std::shared_ptr<HttpServer::ServerContext> context) {
  std::make_shared<HttpSession>(std::move(socket), std::move(context))->read();
}

}  // namespace galilean::monitor
