// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/commands/monitor_client.h"

#include <unistd.h>

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/account.h"
#include "core/json_text.h"
#include "core/visible_text.h"
#include "monitor/access/access.h"
#include "monitor/tls/certificate.h"

namespace galilean::monitor {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;

constexpr std::uint64_t kMostAnswerBytes = 64 << 20;

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

bool is_host(std::string_view text) {
  const bool is_ipv6 = text.starts_with('[') && text.ends_with(']') && text.size() > 2;
  if (!is_ipv6) return !text.empty() && text.find_first_of("/:[]") == text.npos;
  return text.substr(1, text.size() - 2).find_first_not_of("0123456789abcdefABCDEF:") == text.npos;
}

/// Returns a name as a header's field can carry it.
std::string percent_encoded(const std::string& name) {
  static constexpr char kDigits[] = "0123456789ABCDEF";
  std::string text;
  for (const char character : name) {
    const auto byte = static_cast<unsigned char>(character);
    const bool is_plain = byte > ' ' && byte < 0x7f && byte != '%';
    if (is_plain)
      text += character;
    else
      ((text += '%') += kDigits[byte >> 4]) += kDigits[byte & 15];
  }
  return text;
}

/// Returns the fields by which a monitor and its operators know who asks: the user and the process.
const std::string& introduction() {
  static const std::string kFields = "X-Galilean-Operator: " + percent_encoded(user_name()) +
                                     "\r\nX-Galilean-Client: process-" + std::to_string(getpid()) +
                                     "\r\n";
  return kFields;
}

/// Reads "http[s]://HOST[:PORT][/]" or "HOST:PORT", which is what the monitor's --listen takes.
std::optional<MonitorAddress> address_of(std::string_view url) {
  constexpr std::string_view kPlain = "http://", kEncrypted = "https://";
  constexpr std::size_t kMostDigits = 5;
  const bool is_encrypted = url.starts_with(kEncrypted);
  const bool has_scheme = is_encrypted || url.starts_with(kPlain);
  const std::string_view usual_port = is_encrypted ? "443" : has_scheme ? "80" : "";
  if (has_scheme) url.remove_prefix((is_encrypted ? kEncrypted : kPlain).size());
  if (url.ends_with('/')) url.remove_suffix(1);
  const auto colon = url.find(':', url.starts_with('[') ? std::min(url.find(']'), url.size()) : 0);
  const auto host = url.substr(0, colon);
  const auto port = colon != url.npos ? url.substr(colon + 1) : usual_port;
  const bool is_port = !port.empty() && port.size() <= kMostDigits &&
                       port.find_first_not_of("0123456789") == port.npos;
  if (!is_host(host) || !is_port) return std::nullopt;
  return MonitorAddress{std::string(host), std::string(port), is_encrypted};
}

/// Returns `trust`, or trust in the certificate that this user's monitor has made for itself.
ServerTrust trust_of_own(ServerTrust trust) {
  if (!trust.is_empty()) return trust;
  if (auto own = fingerprint_of(own_certificate(default_data_folder()).certificate))
    trust.fingerprint = std::move(own).value();
  return trust;
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

Result<MonitorClient> MonitorClient::at(const std::string& url, const std::string& token_file,
                                        ServerTrust trust) {
  const auto address = address_of(url);
  if (!address) return check_address(url).error();
  if (!address->is_encrypted && !trust.is_empty())
    return Error{"--ca and --fingerprint are of use with https:// only, and not with " + url};
  const bool is_near = is_loopback(without_brackets(address->host));
  if (is_near && address->is_encrypted) trust = trust_of_own(std::move(trust));
  MonitorClient client(url, *address, std::move(trust));
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
  std::string text = method + " " + path + " HTTP/1.1\r\nHost: " + address_.host + ":" +
                     address_.port + "\r\nContent-Type: application/json\r\nConnection: close\r\n";
  if (!token_.empty()) text += "Authorization: Bearer " + token_ + "\r\n";
  text += introduction();
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
  const auto done =
      exchange(address_, trust_, message(method, path, body), std::chrono::seconds(kTimeout_s));
  if (!done) return Unanswered{done.error(), false};
  const Exchanged& exchanged = done.value();
  if (exchanged.is_distrusted)
    return Unanswered{{"the certificate of the monitor at " + url_ +
                       " is not one that is trusted; name it with --ca FILE, or its fingerprint, "
                       "which the monitor prints, with --fingerprint"},
                      false};
  if (exchanged.error) return nobody(exchanged.error, exchanged.was_sent);
  Parser parser;
  if (const auto error = parse(parser, exchanged.answer)) return nobody(error, true);
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
