#include "monitor/server/http/http_messages.h"

#include <boost/beast/http/status.hpp>
#include <charconv>
#include <nlohmann/json.hpp>

#include "monitor/server/json/json_text.h"

namespace galilean::monitor {
namespace http = boost::beast::http;
HttpResponse text_response(std::string text, std::string content_type, int status) {
  return {
      status, std::move(content_type), std::make_shared<const std::string>(std::move(text)), {}};
}

HttpResponse json_response(const nlohmann::json& json, int status) {
  return text_response(json_text(json), "application/json", status);
}

HttpResponse problem(int status, const std::string& detail, const nlohmann::json& more) {
  const auto title = http::obsolete_reason(static_cast<http::status>(status));
  nlohmann::json json{{"title", std::string(title)}, {"status", status}, {"detail", detail}};
  if (more.is_object()) json.update(more);
  return text_response(json_text(json), "application/problem+json", status);
}

HttpResponse problem(int status, const std::string& detail) {
  return problem(status, detail, nlohmann::json::object());
}

HttpResponse refusal(Right has, Right needs) {
  auto response = problem(has == Right::kNone ? 401 : 403, missing_right(needs));
  if (has == Right::kNone) response.headers.emplace_back("WWW-Authenticate", "Bearer");
  return response;
}

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    if (text[i] == '%' && i + 2 < text.size()) {
      const char* end = text.data() + i + 3;
      if (const auto [at, error] = std::from_chars(end - 2, end, byte, 16);
          error == std::errc() && at == end) {
        decoded += static_cast<char>(byte);
        i += 2;
        continue;
      }
    }
    decoded += text[i];
  }
  return decoded;
}

std::string query_value(std::string_view target, std::string_view name) {
  for (auto at = target.find('?'); at != target.npos; at = target.find('&', at + 1)) {
    const auto pair = target.substr(at + 1, target.find('&', at + 1) - at - 1);
    if (pair.size() > name.size() && pair.starts_with(name) && pair[name.size()] == '=')
      return percent_decoded(pair.substr(name.size() + 1));
  }
  return {};
}

}  // namespace galilean::monitor
