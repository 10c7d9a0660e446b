// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.h"

namespace galilean::monitor {

/// Returns a new token of `bytes` random bytes, as hexadecimal digits.
/// Errors: the system gives no random numbers.
[[nodiscard]] Result<std::string> random_token(std::size_t bytes);

/// Returns a token's SHA-256 as 64 hexadecimal digits. One round of SHA-256, without salt, is
/// enough to store: a token is no password, but 256 random bits, so that nobody finds it by trying
/// likely ones, however fast that is.
[[nodiscard]] std::string digest_of(std::string_view token);

/// Compares two digests in a time that does not depend on how many digits agree.
[[nodiscard]] bool is_same_digest(std::string_view a, std::string_view b) noexcept;

}  // namespace galilean::monitor
