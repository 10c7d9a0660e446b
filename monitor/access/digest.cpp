// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/digest.h"

#include <sys/random.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <vector>

#include "bhdl/source/sha256.h"
#include "core/hexadecimal.h"

namespace galilean::monitor {

Result<std::string> random_token(std::size_t bytes) {
  std::vector<std::uint8_t> random(bytes);
  if (getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size()))
    return Error{std::string("the system gives no random numbers: ") + std::strerror(errno)};
  return hexadecimal(random);
}

std::string digest_of(std::string_view token) {
  return bhdl::sha256(token);
}

bool is_same_digest(std::string_view a, std::string_view b) noexcept {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

}  // namespace galilean::monitor
