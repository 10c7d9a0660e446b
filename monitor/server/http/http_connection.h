// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "monitor/server/http/http_server.h"

namespace galilean::monitor {

/// What a connection keeps of what it has read and not used yet: a request's head at most.
inline constexpr std::size_t kMostBufferedBytes = std::size_t{64} << 10;

/// Reads the requests of one connection and answers them, until it closes or becomes a WebSocket.
/// Where the method is PUT, the body is given away piece by piece. Answers may be read from a file
/// while they are sent. Own it by a shared_ptr; it owns itself while anything is under way.
class HttpConnection final : public IncomingBody,
                             public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(boost::asio::ip::tcp::socket socket,
                 std::shared_ptr<HttpServer::ServerContext> context, std::string address,
                 std::shared_ptr<Connections::Place> place);
  ~HttpConnection() override;

  /// Reads the next request.
  void read();
  void next(Take take) override;

 private:
  using error_code = boost::system::error_code;
  template <class Body>
  using Request = boost::beast::http::request<Body>;
  template <class Body>
  using Parser = boost::beast::http::request_parser<Body>;
  using TextRequest = Request<boost::beast::http::string_body>;

  // Reading, and who answers: http_session.cpp.
  void fail(error_code error);
  void read_head();
  void take_head(std::size_t bytes);
  void refuse(int status, const std::string& why);
  [[nodiscard]] bool keep_body(std::uint64_t bytes);
  void let_body_go();
  void wait_for_others();
  template <class Work>
  void attempt(Work work);
  void read_body();
  [[nodiscard]] std::size_t most_body_bytes() const;
  void receive();
  template <class Body>
  [[nodiscard]] std::optional<HttpRequest> begin(const Request<Body>& message);
  [[nodiscard]] std::string origin_for(const HttpRequest& request) const;
  void become_websocket(const HttpRequest& request, const TextRequest& message);
  void handle(HttpRequest request);

  // What tokens permit: http_rights.cpp.
  [[nodiscard]] Right right_of(const HttpRequest& request);
  [[nodiscard]] OperatorId sender_of(const HttpRequest& request) const;
  [[nodiscard]] std::optional<Duration> held_off();
  [[nodiscard]] static HttpResponse too_many_guesses(Duration wait);
  [[nodiscard]] bool is_withdrawn() const;

  // Bodies in pieces, in both directions: http_pieces.cpp.
  void say_continue(Take take);
  void take_piece(error_code error, const Take& take);
  void send_piece();
  [[nodiscard]] bool read_piece();
  void write_piece();
  void close();
  void pass_over_rest();

  // Answers: http_answer.cpp.
  void respond(HttpResponse response);
  void write_head(const HttpResponse& response);
  void write_field(std::string_view name, std::string_view value);
  void go_on();

  boost::beast::tcp_stream stream_;
  std::shared_ptr<HttpServer::ServerContext> context_;
  std::shared_ptr<Connections::Place> place_;
  boost::beast::flat_buffer buffer_{kMostBufferedBytes};
  std::optional<Parser<boost::beast::http::empty_body>> head_parser_;
  std::optional<Parser<boost::beast::http::string_body>> parser_;
  std::optional<Parser<boost::beast::http::buffer_body>> stream_parser_;  ///< where it is a PUT
  std::optional<StreamedBody> outgoing_;                                  ///< what is left of it
  std::vector<std::uint8_t> piece_;
  std::shared_ptr<const std::string> body_;
  std::string head_;
  std::string allowed_origin_;
  std::string address_;               ///< the client's
  std::string digest_;                ///< of the token that the last request sent; else empty
  Right token_right_ = Right::kNone;  ///< what that token gave
  std::string body_path_;             ///< which says how long the body may be
  unsigned version_ = 11;
  std::uint64_t handled_ = 0;  ///< requests that the handler got
  bool awaits_answer_ = false;
  bool awaits_continue_ = false;  ///< the client sends its body when it is told to
  bool leaves_body_ = false;      ///< whether a part of the request's body was not read
  std::size_t kept_bytes_ = 0;    ///< of the body, as the server counts long ones
  bool keep_alive_ = false;
  bool head_only_ = false;
};

/// How long a request, or a piece of a body in either direction, may take.
inline constexpr auto kLongestRequest = std::chrono::seconds(30);

}  // namespace galilean::monitor
