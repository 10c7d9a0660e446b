// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_messages.h"

#include <boost/beast/http/status.hpp>
#include <nlohmann/json.hpp>

#include "core/json_text.h"

namespace galilean::monitor {
namespace http = boost::beast::http;
namespace {
constexpr int kRetryAfter_s = 2;
}

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
  auto response = text_response(json_text(json), "application/problem+json", status);
  if (status == 503) response.headers.emplace_back("Retry-After", std::to_string(kRetryAfter_s));
  return response;
}

HttpResponse problem(int status, const std::string& detail) {
  return problem(status, detail, nlohmann::json::object());
}

HttpResponse refusal(Right has, Right needs) {
  auto response = problem(has == Right::kNone ? 401 : 403, missing_right(needs));
  if (has == Right::kNone) response.headers.emplace_back("WWW-Authenticate", "Bearer");
  return response;
}

}  // namespace galilean::monitor
