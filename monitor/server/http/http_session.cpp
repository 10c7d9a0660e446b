// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_session.h"

#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

#include "monitor/background/guarded.h"
#include "monitor/server/http/http_connection.h"
#include "monitor/server/http/websocket_session.h"
#include "monitor/server/text/url_text.h"

namespace galilean::monitor {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;

constexpr std::uint32_t kMostHeaderBytes = 16 << 10;
constexpr std::uint64_t kMostBodyBytes = 16 << 20;

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
  const auto name = from["X-Galilean-Operator"];
  request.operator_name = percent_decoded({name.data(), name.size()});
  request.client = from["X-Galilean-Client"];
  request.range = from[http::field::range];
  request.if_range = from[http::field::if_range];
  return request;
}

bool is_for_websockets(std::string_view path) {
  return path == "/ws" || path == "/lsp" || path == "/replay";
}

HttpResponse websocket_needed(const std::string& path) {
  auto response =
      problem(426, "'" + path + "' is for WebSockets: open ws:// and not http:// there.");
  response.headers.emplace_back("Upgrade", "websocket");
  return response;
}

}  // namespace

HttpConnection::HttpConnection(boost::asio::ip::tcp::socket socket,
                               std::shared_ptr<HttpServer::ServerContext> context,
                               std::string address)
    : stream_(std::move(socket)), context_(std::move(context)), address_(std::move(address)) {
  ++context_->counts.connections;
  error_code ignored;
  stream_.socket().set_option(boost::asio::ip::tcp::no_delay(true), ignored);
}

HttpConnection::~HttpConnection() {
  --context_->counts.connections;
}

void HttpConnection::read() {
  allowed_origin_.clear();
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

void HttpConnection::fail(error_code error) {
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
void HttpConnection::attempt(Work work) {
  const auto done = guarded("a request", work);
  if (!done && awaits_answer_)
    respond(problem(500, "The monitor failed at this request: " + done.error().message + "."));
}

void HttpConnection::read_body() {
  awaits_answer_ = true;
  const auto length = head_parser_->content_length();
  if (head_parser_->get().method() == http::verb::put) {
    stream_parser_.emplace(std::move(*head_parser_));
    stream_parser_->body_limit(boost::none);
    const auto& head = stream_parser_->get();
    awaits_continue_ = beast::iequals(head[http::field::expect], "100-continue");
    auto request = begin(head);
    if (!request) return;
    if (length) request->body_bytes = *length;
    request->body_stream = shared_from_this();
    return handle(*request);
  }
  if (length.value_or(0) > kMostBodyBytes) return fail(http::error::body_limit);
  parser_.emplace(std::move(*head_parser_));
  parser_->body_limit(kMostBodyBytes);
  if (parser_->is_done()) return receive();
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](error_code error, std::size_t) {
                     if (error) return self->fail(error);
                     self->attempt([&] { self->receive(); });
                   });
}

void HttpConnection::receive() {
  auto message = parser_->release();
  auto request = begin(message);
  if (!request) return;
  if (is_for_websockets(request->path)) {
    if (beast::websocket::is_upgrade(message)) return become_websocket(*request, message);
    return respond(websocket_needed(request->path));
  }
  request->body = std::move(message.body());
  handle(*request);
}

/// Takes a message's head. Returns nothing if the guard refused it, which is answered.
template <class Body>
std::optional<HttpRequest> HttpConnection::begin(const Request<Body>& message) {
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
  request.right = right_of(request);
  if (const auto wait = held_off()) {
    respond(too_many_guesses(*wait));
    return {};
  }
  request.who = sender_of(request);
  return request;
}

std::string HttpConnection::origin_for(const HttpRequest& request) const {
  if (request.path.starts_with(Guard::kSharedPath)) return "*";
  return context_->guard.is_allowed_origin(request.origin) ? request.origin : std::string();
}

void HttpConnection::become_websocket(const HttpRequest& request, const TextRequest& message) {
  if (request.right == Right::kNone) return respond(refusal(Right::kNone, Right::kRead));
  stream_.expires_never();
  auto socket = stream_.release_socket();
  auto& rounds = context_->rounds;
  std::weak_ptr<Revocable> session;
  if (request.path == "/lsp")
    session = serve_language(std::move(socket), message, rounds, context_->language);
  else if (request.path == "/replay")
    session = serve_replay(std::move(socket), message, rounds, context_->replay);
  else
    session = serve_websocket(std::move(socket), message, context_->hub, rounds, request.right,
                              request.who);
  if (token_right_ != Right::kNone)
    context_->sockets.add(digest_, token_right_, std::move(session));
}

void HttpConnection::handle(const HttpRequest& request) {
  stream_.expires_never();
  context_->handler(request,
                    [self = shared_from_this(), number = ++handled_](HttpResponse response) {
                      // Only the first answer to a request is sent.
                      if (self->awaits_answer_ && self->handled_ == number)
                        self->respond(std::move(response));
                    });
}

void serve_http(boost::asio::ip::tcp::socket socket,
                std::shared_ptr<HttpServer::ServerContext> context, std::string address) {
  std::make_shared<HttpConnection>(std::move(socket), std::move(context), std::move(address))
      ->read();
}

}  // namespace galilean::monitor
