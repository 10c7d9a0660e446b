// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_session.h"

#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

#include "monitor/background/guarded.h"
#include "monitor/server/http/http_connection.h"
#include "monitor/server/http/http_strictness.h"
#include "monitor/server/http/websocket_session.h"
#include "monitor/server/text/url_text.h"

namespace galilean::monitor {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;

constexpr std::size_t kHeadPieceBytes = 4096;

/// Returns the path that a request is for, without its query.
std::string path_of(std::string_view target) {
  return percent_decoded(target.substr(0, target.find('?')));
}

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
  request.path = path_of(target);
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
                               std::string address, std::shared_ptr<Connections::Place> place)
    : stream_(std::move(socket)),
      context_(std::move(context)),
      place_(std::move(place)),
      address_(std::move(address)) {
  ++context_->counts.connections;
  error_code ignored;
  stream_.socket().set_option(boost::asio::ip::tcp::no_delay(true), ignored);
}

HttpConnection::~HttpConnection() {
  let_body_go();
  --context_->counts.connections;
}

void HttpConnection::read() {
  allowed_origin_.clear();
  head_parser_.emplace();
  head_parser_->header_limit(static_cast<std::uint32_t>(context_->limits.header_bytes));
  head_parser_->body_limit(boost::none);  // each kind of body has a limit of its own
  wait_for_others();
  head_only_ = false;
  stream_.expires_after(kLongestRequest);
  read_head();
}

/// Reads until the request's head is there, or more than a head may have. It is looked at before it
/// is parsed, because the parser forgives what RFC 9112 does not.
void HttpConnection::read_head() {
  const auto read = buffer_.cdata();
  const auto bytes = head_size({static_cast<const char*>(read.data()), read.size()});
  if (bytes || read.size() > context_->limits.header_bytes) {
    place_->serve();
    return attempt([&] { take_head(bytes.value_or(read.size())); });
  }
  stream_.async_read_some(buffer_.prepare(kHeadPieceBytes),
                          [self = shared_from_this()](error_code error, std::size_t more) {
                            if (error) return;
                            self->buffer_.commit(more);
                            self->read_head();
                          });
}

/// The connection may be closed from now on if another one needs its place.
void HttpConnection::wait_for_others() {
  place_->wait([weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->close();
  });
}

void HttpConnection::take_head(std::size_t bytes) {
  awaits_answer_ = true;
  const auto buffered = buffer_.cdata();
  const std::string_view head(static_cast<const char*>(buffered.data()), bytes);
  if (bytes > context_->limits.header_bytes) return fail(http::error::header_limit);
  if (const auto malformed = malformed_lines(head))
    return refuse(malformed->status, malformed->why);
  error_code error;
  const auto used = head_parser_->put(boost::asio::buffer(head.data(), head.size()), error);
  if (error && error != http::error::need_more) return fail(error);
  if (!head_parser_->is_header_done()) return refuse(400, "This is not HTTP: the head is cut off.");
  buffer_.consume(used);
  if (const auto malformed =
          malformed_fields(head_parser_->get().base(), context_->limits.header_fields))
    return refuse(malformed->status, malformed->why);
  read_body();
}

void HttpConnection::fail(error_code error) {
  if (error == http::error::body_limit) {
    context_->limit_counts->reached(Limit::kBody);
    return refuse(413, "The request's body is larger than " + std::to_string(most_body_bytes()) +
                           " bytes, which are the most that its path takes.");
  }
  if (error == http::error::header_limit) {
    context_->limit_counts->reached(Limit::kHeaders);
    return refuse(431, "The request's header is larger than " +
                           std::to_string(context_->limits.header_bytes) + " bytes.");
  }
  if (error.category() == make_error_code(http::error::bad_method).category() &&
      error != http::error::end_of_stream && error != http::error::partial_message)
    refuse(400, "This is not HTTP: " + error.message() + ".");
}

/// Answers a request behind which nothing more can be read, and closes the connection.
void HttpConnection::refuse(int status, const std::string& why) {
  if (status == 400 || status == 501) ++context_->counts.malformed;
  keep_alive_ = false;
  version_ = 11;
  respond(problem(status, why));
}

template <class Work>
void HttpConnection::attempt(Work work) {
  const auto done = guarded("a request", work);
  if (!done && awaits_answer_)
    respond(problem(500, "The monitor failed at this request: " + done.error().message + "."));
}

void HttpConnection::read_body() {
  const auto target = head_parser_->get().target();
  body_path_ = path_of({target.data(), target.size()});
  const auto length = head_parser_->content_length();
  const auto most = most_body_bytes();
  if (head_parser_->get().method() == http::verb::put) {
    stream_parser_.emplace(std::move(*head_parser_));
    stream_parser_->body_limit(boost::none);
    const auto& head = stream_parser_->get();
    awaits_continue_ = beast::iequals(head[http::field::expect], "100-continue");
    auto request = begin(head);
    if (!request) return;
    if (length) request->body_bytes = *length;
    request->body_stream = shared_from_this();
    return handle(std::move(*request));
  }
  if (length.value_or(0) > most) return fail(http::error::body_limit);
  const bool is_kept = keep_body(head_parser_->chunked() ? most : length.value_or(0));
  if (!is_kept)
    return refuse(503, "The monitor reads as many long bodies as it keeps; ask again in a moment.");
  parser_.emplace(std::move(*head_parser_));
  parser_->body_limit(most);
  if (parser_->is_done()) return receive();
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](error_code error, std::size_t) {
                     if (error) return self->fail(error);
                     self->attempt([&] { self->receive(); });
                   });
}

std::size_t HttpConnection::most_body_bytes() const {
  if (!context_->most_body_bytes) return context_->limits.program.bytes;
  return context_->most_body_bytes(body_path_);
}

/// Counts a long body among those that are kept. Returns false if there is no room for it. Short
/// ones are not counted, so that a command is never refused because of others' programs.
bool HttpConnection::keep_body(std::uint64_t bytes) {
  if (bytes <= context_->limits.breaks.bytes) return true;
  if (context_->bodies_bytes + bytes > context_->limits.bodies_bytes) {
    context_->limit_counts->reached(Limit::kBodies);
    return false;
  }
  kept_bytes_ = static_cast<std::size_t>(bytes);
  context_->bodies_bytes += kept_bytes_;
  return true;
}

void HttpConnection::let_body_go() {
  context_->bodies_bytes -= std::exchange(kept_bytes_, 0);
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
  handle(std::move(*request));
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
    if (place_->is_reserved()) keep_alive_ = false;
    respond(too_many_guesses(*wait));
    return {};
  }
  if (place_->is_reserved() && request.right != Right::kOperate) {
    refuse(503,
           "As many connections are open as the monitor keeps, and those that are left are for "
           "operators; close others, or ask again in a moment.");
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
    session = serve_language(std::move(socket), message, rounds, context_->language, place_);
  else if (request.path == "/replay")
    session = serve_replay(std::move(socket), message, rounds, context_->replay, place_);
  else
    session = serve_websocket(std::move(socket), message, context_->hub, rounds, request.right,
                              request.who, place_);
  if (token_right_ != Right::kNone)
    context_->sockets.add(digest_, token_right_, std::move(session));
}

/// An operator's orders pass by all other requests, which are answered in turn.
void HttpConnection::handle(HttpRequest request) {
  stream_.expires_never();
  const bool is_order = request.right == Right::kOperate && request.method == "POST";
  auto work = [self = shared_from_this(), number = ++handled_, asked = std::move(request)] {
    self->attempt([&] {
      self->context_->handler(asked, [self, number](HttpResponse response) {
        // Only the first answer to a request is sent.
        if (self->awaits_answer_ && self->handled_ == number) self->respond(std::move(response));
      });
    });
  };
  if (is_order) return work();
  place_->in_turn(std::move(work));
}

void serve_http(boost::asio::ip::tcp::socket socket,
                std::shared_ptr<HttpServer::ServerContext> context, std::string address,
                std::shared_ptr<Connections::Place> place) {
  std::make_shared<HttpConnection>(std::move(socket), std::move(context), std::move(address),
                                   std::move(place))
      ->read();
}

}  // namespace galilean::monitor
