// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/monitor_client.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <filesystem>
#include <regex>

#include "core/json_text.h"
#include "monitor/access/access.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;

constexpr std::uint64_t kMostAnswerBytes = 64 << 20;

/// One request and its answer, on a connection of its own.
class Exchange {
 public:
  Exchange(asio::io_context& io, http::request<http::string_body> request)
      : stream_(io), request_(std::move(request)) {
    parser_.body_limit(kMostAnswerBytes);
  }

  void start(const asio::ip::tcp::resolver::results_type& endpoints) {
    stream_.expires_after(std::chrono::seconds(MonitorClient::kPatience_s));
    stream_.async_connect(endpoints, [this](error_code error, const auto&) {
      if (!failed(error)) write();
    });
  }
  [[nodiscard]] error_code error() const { return error_; }
  [[nodiscard]] const auto& response() const { return parser_.get(); }

 private:
  bool failed(error_code error) {
    error_ = error;
    return bool(error);
  }
  void write() {
    http::async_write(stream_, request_, [this](error_code error, std::size_t) {
      if (!failed(error)) read();
    });
  }
  void read() {
    http::async_read(stream_, buffer_, parser_,
                     [this](error_code error, std::size_t) { failed(error); });
  }

  beast::tcp_stream stream_;
  http::request<http::string_body> request_;
  beast::flat_buffer buffer_;
  http::response_parser<http::string_body> parser_;
  error_code error_;
};

/// "[::1]" -> "::1"
std::string without_brackets(const std::string& host) {
  return host.starts_with('[') ? host.substr(1, host.size() - 2) : host;
}

}  // namespace

std::string MonitorAnswer::detail() const {
  if (json.is_object() && json.contains("detail")) return json["detail"].get<std::string>();
  return "the monitor answered " + std::to_string(status);
}

Result<MonitorClient> MonitorClient::at(const std::string& url, const std::string& token_file) {
  static const std::regex kForm(R"(http://(\[[0-9a-fA-F:]+\]|[^/:\[\]]+)(?::(\d{1,5}))?/?)");
  std::smatch found;
  if (!std::regex_match(url, found, kForm))
    return Error{"'" + url + "' is no address of a monitor, such as http://127.0.0.1:8080"};
  MonitorClient client(url, found[1], found[2].matched ? found[2].str() : "80");
  const bool is_near = is_loopback(without_brackets(client.host_));
  const auto file = operator_token_file(default_data_folder());
  if (std::error_code none;
      token_file.empty() && (!is_near || !std::filesystem::exists(file, none)))
    return client;
  auto token = read_token(token_file.empty() ? file : std::filesystem::path(token_file));
  if (!token) return token.error();
  client.token_ = std::move(token).value();
  return client;
}

Result<MonitorAnswer> MonitorClient::get(const std::string& path) const {
  return request("GET", path, {});
}

Result<MonitorAnswer> MonitorClient::post(const std::string& path,
                                          const nlohmann::json& body) const {
  return request("POST", path, json_text(body));
}

Result<MonitorAnswer> MonitorClient::request(const std::string& method, const std::string& path,
                                             const std::string& body) const {
  const auto nobody = [&](const error_code& why) {
    return Error{"no monitor answers at " + url_ + " (" + why.message() +
                 "); start one with 'galilean monitor', or name another with --monitor"};
  };
  http::request<http::string_body> message;
  message.method_string(method);
  message.target(path);
  message.version(11);
  message.set(http::field::host, host_ + ":" + port_);
  message.set(http::field::content_type, "application/json");
  message.set(http::field::connection, "close");
  if (!token_.empty()) message.set(http::field::authorization, "Bearer " + token_);
  message.body() = body;
  message.prepare_payload();

  asio::io_context io;
  error_code unknown;
  asio::ip::tcp::resolver resolver(io);
  const auto endpoints = resolver.resolve(without_brackets(host_), port_, unknown);
  if (unknown) return nobody(unknown);
  Exchange exchange(io, std::move(message));
  exchange.start(endpoints);
  io.run();
  if (exchange.error()) return nobody(exchange.error());
  return MonitorAnswer{static_cast<int>(exchange.response().result_int()),
                       nlohmann::json::parse(exchange.response().body(), nullptr, false)};
}

}  // namespace galilean::monitor
