// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "monitor/access/right.h"

namespace galilean::monitor {

/// One person's token, as `galilean tokens` keeps it. Times are seconds since 1970 (UTC). The token
/// itself is kept nowhere.
struct NamedToken {
  std::string name;
  Right right = Right::kRead;
  std::string sha256;  ///< the token's digest, 64 hexadecimal digits
  std::int64_t made_s = 0;
  std::optional<std::int64_t> expires_s;  ///< from then on it gives no right

  [[nodiscard]] bool is_expired(std::int64_t now_s) const noexcept {
    return expires_s && *expires_s <= now_s;
  }
};

/// Returns the word for a right that a token can give: "operator" or "viewer".
[[nodiscard]] std::string_view role_of(Right right) noexcept;
/// Returns the machine's wall clock [s since 1970].
[[nodiscard]] std::int64_t wall_clock_s();

/// Returns the path of the named tokens in a data folder.
[[nodiscard]] std::filesystem::path named_tokens_file(const std::filesystem::path& data_folder);
/// Returns the tokens in the order in which they were added; none if the file is not there.
/// Errors: the file cannot be read, is damaged, or may be written by others. The sentence says what
/// to do.
[[nodiscard]] Result<std::vector<NamedToken>> read_named_tokens(const std::filesystem::path& file);

/// Adds a token of 256 random bits to those of a data folder, in place of an expired one of that
/// name, and returns it. `wanted` needs no digest. Safe beside other processes that do so.
/// Errors: the name is not usable or is in use, or the file cannot be read or written.
[[nodiscard]] Result<std::string> add_named_token(const std::filesystem::path& data_folder,
                                                  NamedToken wanted);
/// Removes a token.
/// Errors: there is none of that name, or the file cannot be read or written.
[[nodiscard]] Result<void> revoke_named_token(const std::filesystem::path& data_folder,
                                              const std::string& name);

}  // namespace galilean::monitor
