// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/tls/openssl.h"

#include <openssl/err.h>

#include <array>

namespace galilean::monitor::openssl {

std::string last_problem() {
  const auto code = ERR_get_error();
  ERR_clear_error();
  if (code == 0) return "for an unknown reason";
  std::array<char, 256> text{};
  ERR_error_string_n(code, text.data(), text.size());
  return text.data();
}

}  // namespace galilean::monitor::openssl
