// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/uri.h"

#include <cctype>

#include "bhdl/source/source_provider.h"

namespace galilean::bhdl::lsp {
namespace {

constexpr std::string_view kFile = "file:";
constexpr std::string_view kDigits = "0123456789ABCDEF";

int digit(char c) noexcept {
  const auto found = kDigits.find(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
  return found == std::string_view::npos ? -1 : static_cast<int>(found);
}

std::string decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape =
        text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0;
    if (!escape) {
      result += text[i];
      continue;
    }
    result += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
    i += 2;
  }
  return result;
}

bool stands_for_itself(char c) noexcept {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

// `file:///a` has an empty authority. The host of `file://host/a` is ignored, because files are
// read on this machine.
std::string_view without_authority(std::string_view rest) {
  if (!rest.starts_with("//")) return rest;
  const auto slash = rest.find('/', 2);
  return slash == std::string_view::npos ? std::string_view() : rest.substr(slash);
}

}  // namespace

std::string path_of(std::string_view uri) {
  if (!uri.starts_with(kFile)) return decoded(uri);
  return normal_path(decoded(without_authority(uri.substr(kFile.size()))));
}

std::string uri_of(std::string_view path) {
  std::string uri = "file://";
  for (const char c : path) {
    if (stands_for_itself(c)) {
      uri += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    uri.append({'%', kDigits[byte >> 4], kDigits[byte & 15]});
  }
  return uri;
}

}  // namespace galilean::bhdl::lsp
