// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/protocol/framing.h"

#include <charconv>

#include "bhdl/source/text.h"

namespace galilean::bhdl::lsp {
namespace {

constexpr std::string_view kLength = "content-length:";
constexpr std::string_view kHeaderEnd = "\r\n\r\n";

std::optional<std::size_t> length_in(std::string_view header) {
  const std::string lower = lower_case(header);
  const auto at = lower.starts_with(kLength) ? 0 : lower.find("\r\n" + std::string(kLength));
  if (at == std::string::npos) return std::nullopt;
  auto digits = header.substr(header.find(':', at) + 1);
  digits.remove_prefix(std::min(digits.find_first_not_of(" \t"), digits.size()));
  std::size_t length = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), length);
  return parsed.ec == std::errc() ? std::optional(length) : std::nullopt;
}

}  // namespace

Result<std::optional<std::size_t>> Framing::read_header() {
  const auto end = waiting_.find(kHeaderEnd);
  if (end == std::string::npos) {
    if (waiting_.size() > kMostHeaderBytes)
      return Error{"a message begins with \"Content-Length: \" and its size in bytes"};
    return std::optional<std::size_t>();
  }
  const auto length = length_in(std::string_view(waiting_).substr(0, end));
  if (!length) return Error{"a message's head lacks \"Content-Length: \" and its size in bytes"};
  if (*length > kMostMessageBytes) return Error{"a message has more than 32 MiB"};
  waiting_.erase(0, end + kHeaderEnd.size());
  return length;
}

Result<std::optional<std::string>> Framing::next() {
  if (!body_bytes_) {
    const auto header = read_header();
    if (!header) return header.error();
    body_bytes_ = header.value();
  }
  if (!body_bytes_ || waiting_.size() < *body_bytes_) return std::optional<std::string>();
  std::string message = waiting_.substr(0, *body_bytes_);
  waiting_.erase(0, *body_bytes_);
  body_bytes_.reset();
  return std::optional(std::move(message));
}

std::string framed(std::string_view message) {
  return "Content-Length: " + std::to_string(message.size()) + "\r\n\r\n" + std::string(message);
}

}  // namespace galilean::bhdl::lsp
