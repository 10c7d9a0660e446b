// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_session.h"

#include <array>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>
#include <string>
#include <string_view>

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
constexpr auto kLongestRequest = std::chrono::seconds(30);

/// Returns the bearer's token, else `token` of the query. A browser cannot send a bearer's token
/// with a WebSocket, so it names the token there: ?token=…
std::string token_of(std::string_view authorization, std::string_view target) {
  constexpr std::string_view kBearer = "Bearer ";
  if (authorization.starts_with(kBearer)) return std::string(authorization.substr(kBearer.size()));
  return query_value(target, "token");
}

HttpRequest plain(http::request<http::string_body>& from) {
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
  request.body = std::move(from.body());
  return request;
}

class HttpSession : public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(boost::asio::ip::tcp::socket socket,
              std::shared_ptr<HttpServer::ServerContext> context)
      : stream_(std::move(socket)), context_(std::move(context)) {
    ++context_->counts.connections;
    error_code ignored;
    stream_.socket().set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  }
  ~HttpSession() { --context_->counts.connections; }

  void read() {
    parser_.emplace();
    parser_->header_limit(kMostHeaderBytes);
    parser_->body_limit(kMostBodyBytes);
    stream_.expires_after(kLongestRequest);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                       if (error) return self->fail(error);
                       const auto done = guarded("a request", [&] { self->receive(); });
                       if (!done) self->respond_internal_error(done.error().message);
                     });
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

  void receive() {
    auto message = parser_->release();
    awaits_answer_ = true;
    version_ = message.version();
    keep_alive_ = message.keep_alive();
    head_only_ = message.method() == http::verb::head;
    const bool upgrade = beast::websocket::is_upgrade(message);
    auto request = plain(message);
    ++context_->counts.requests;
    if (const auto admitted = context_->guard.admit(request); !admitted) {
      ++context_->counts.refused;
      return respond(problem(403, admitted.error().message));
    }
    request.right = context_->access.right_of(request.token);
    if (upgrade && (request.path == "/ws" || request.path == "/lsp")) {
      if (request.right == Right::kNone) return respond(refusal(Right::kNone, Right::kRead));
      if (request.path == "/lsp") return become_language_server(message);
      return become_websocket(message, request.right);
    }
    allowed_origin_ =
        context_->guard.is_allowed_origin(request.origin) ? request.origin : std::string();
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

  void respond(HttpResponse response) {
    awaits_answer_ = false;
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
                               if (!error) self->go_on();
                             });
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
    if (response.status != 304) write_field("Content-Length", std::to_string(body_->size()));
    head_.append("\r\n");
  }

  void write_field(std::string_view name, std::string_view value) {
    head_.append(name).append(": ").append(value).append("\r\n");
  }

  void go_on() {
    if (keep_alive_) return read();
    error_code ignored;
    stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  }

  beast::tcp_stream stream_;
  std::shared_ptr<HttpServer::ServerContext> context_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  std::shared_ptr<const std::string> body_;
  std::string head_;
  std::string allowed_origin_;
  unsigned version_ = 11;
  std::uint64_t handled_ = 0;  ///< requests that the handler got
  bool awaits_answer_ = false;
  bool keep_alive_ = false;
  bool head_only_ = false;
};

}  // namespace

void serve_http(boost::asio::ip::tcp::socket socket,
                std::shared_ptr<HttpServer::ServerContext> context) {
  std::make_shared<HttpSession>(std::move(socket), std::move(context))->read();
}

}  // namespace galilean::monitor
