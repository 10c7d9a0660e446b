// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/text/url_text.h"

#include <charconv>

namespace galilean::monitor {

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
