// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/monitor_client.h"

#include <algorithm>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/json_text.h"
#include "core/visible_text.h"
#include "monitor/access/access.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;

constexpr std::uint64_t kMostAnswerBytes = 64 << 20;

/// One request and its answer, on a connection of its own, which the monitor closes.
class Exchange {
 public:
  Exchange(asio::io_context& io, std::string request) : socket_(io), request_(std::move(request)) {}

  void start(const asio::ip::tcp::resolver::results_type& endpoints) {
    asio::async_connect(socket_, endpoints, [this](error_code error, const auto&) {
      if (failed(error)) return;
      is_connected_ = true;
      write();
    });
  }
  /// Returns whether the monitor may have got the request.
  [[nodiscard]] bool was_sent() const { return is_connected_; }
  /// Returns the error of the exchange. Before its end, that is timed_out.
  [[nodiscard]] error_code error() const { return error_; }
  /// Returns all bytes of the answer.
  [[nodiscard]] const std::string& answer() const { return answer_; }

 private:
  bool failed(error_code error) {
    if (error) error_ = error;
    return bool(error);
  }
  void write() {
    asio::async_write(socket_, asio::buffer(request_), [this](error_code error, std::size_t) {
      if (!failed(error)) read();
    });
  }
  void read() {
    asio::async_read(socket_, asio::dynamic_buffer(answer_, kMostAnswerBytes),
                     [this](error_code error, std::size_t) {
                       error_ = error == asio::error::eof ? error_code() : error;
                     });
  }

  asio::ip::tcp::socket socket_;
  std::string request_;
  std::string answer_;
  error_code error_ = asio::error::timed_out;
  bool is_connected_ = false;
};

using Parser = http::response_parser<http::string_body>;

error_code parse(Parser& parser, const std::string& answer) {
  error_code error;
  parser.eager(true);
  parser.body_limit(kMostAnswerBytes);
  for (std::size_t at = 0; at < answer.size() && !parser.is_done() && !error;)
    at += parser.put(asio::buffer(answer) + at, error);
  if (!error && !parser.is_done()) parser.put_eof(error);
  return error;
}

struct Address {
  std::string host;  ///< with brackets if it is an IPv6 address
  std::string port;
};

bool is_host(std::string_view text) {
  const bool is_ipv6 = text.starts_with('[') && text.ends_with(']') && text.size() > 2;
  if (!is_ipv6) return !text.empty() && text.find_first_of("/:[]") == text.npos;
  return text.substr(1, text.size() - 2).find_first_not_of("0123456789abcdefABCDEF:") == text.npos;
}

/// Reads "http://HOST[:PORT][/]" or "HOST:PORT", which is what the monitor's --listen takes.
std::optional<Address> address_of(std::string_view url) {
  constexpr std::string_view kScheme = "http://";
  constexpr std::size_t kMostDigits = 5;
  const bool has_scheme = url.starts_with(kScheme);
  if (has_scheme) url.remove_prefix(kScheme.size());
  if (url.ends_with('/')) url.remove_suffix(1);
  const auto colon = url.find(':', url.starts_with('[') ? std::min(url.find(']'), url.size()) : 0);
  const auto host = url.substr(0, colon);
  const auto port = colon != url.npos ? url.substr(colon + 1) : has_scheme ? "80" : "";
  const bool is_port = !port.empty() && port.size() <= kMostDigits &&
                       port.find_first_not_of("0123456789") == port.npos;
  if (!is_host(host) || !is_port) return std::nullopt;
  return Address{std::string(host), std::string(port)};
}

/// Returns "::1" for "[::1]".
std::string without_brackets(const std::string& host) {
  return host.starts_with('[') ? host.substr(1, host.size() - 2) : host;
}

}  // namespace

std::string MonitorAnswer::detail() const {
  const auto detail = json.is_object() ? json.find("detail") : json.end();
  if (detail != json.end() && detail->is_string()) return detail->get<std::string>();
  return "the monitor answered " + std::to_string(status);
}

Result<void> MonitorClient::check_address(const std::string& url) {
  if (address_of(url)) return {};
  return Error{"'" + visible(url) +
               "' is not a valid address of a monitor, such as http://127.0.0.1:8080"};
}

Result<MonitorClient> MonitorClient::at(const std::string& url, const std::string& token_file) {
  const auto address = address_of(url);
  if (!address) return check_address(url).error();
  MonitorClient client(url, address->host, address->port);
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

Result<MonitorAnswer, Unanswered> MonitorClient::get(const std::string& path) const {
  return request("GET", path, {});
}

Result<MonitorAnswer, Unanswered> MonitorClient::post(const std::string& path,
                                                      const nlohmann::json& body) const {
  return request("POST", path, json_text(body));
}

std::string MonitorClient::message(const std::string& method, const std::string& path,
                                   const std::string& body) const {
  std::string text = method + " " + path + " HTTP/1.1\r\nHost: " + host_ + ":" + port_ +
                     "\r\nContent-Type: application/json\r\nConnection: close\r\n";
  if (!token_.empty()) text += "Authorization: Bearer " + token_ + "\r\n";
  return text + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

Result<MonitorAnswer, Unanswered> MonitorClient::request(const std::string& method,
                                                         const std::string& path,
                                                         const std::string& body) const {
  const auto nobody = [&](const error_code& why, bool was_sent) {
    return Unanswered{{"no monitor answers at " + url_ + " (" + why.message() +
                       "); start one with 'galilean monitor', or name another with --monitor"},
                      was_sent};
  };
  asio::io_context io;
  error_code unknown;
  asio::ip::tcp::resolver resolver(io);
  const auto endpoints = resolver.resolve(without_brackets(host_), port_, unknown);
  if (unknown) return nobody(unknown, false);
  Exchange exchange(io, message(method, path, body));
  exchange.start(endpoints);
  io.run_for(std::chrono::seconds(kTimeout_s));
  if (exchange.error()) return nobody(exchange.error(), exchange.was_sent());
  Parser parser;
  if (const auto error = parse(parser, exchange.answer())) return nobody(error, true);
  MonitorAnswer answer{static_cast<int>(parser.get().result_int()),
                       nlohmann::json(nlohmann::json::value_t::discarded)};
  if (auto body_read = read_json(parser.get().body())) answer.json = std::move(body_read).value();
  if (answer.ok() && !answer.json.is_object())
    return Unanswered{{"what answers at " + url_ +
                       " is no monitor of Galilean; name the monitor's address with --monitor"},
                      true};
  return answer;
}

}  // namespace galilean::monitor
