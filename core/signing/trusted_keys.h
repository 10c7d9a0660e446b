// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/signing/verifying_key.h"

namespace galilean {

/// The first word of a line that names a key.
inline constexpr std::string_view kKeyKind = "ed25519";

/// The public keys whose orders a robot obeys. In a file each stands in a line of its own, as
/// "ed25519 BASE64 NAME". Empty lines, and those that begin with '#', name none.
class TrustedKeys {
 public:
  struct Trusted {
    std::string id;    ///< VerifyingKey::id
    std::string name;  ///< whose key it is; may be empty
    VerifyingKey key;
  };

  /// Reads a file. Errors: it cannot be read, everybody may write it, it is a private key, a line
  /// of it names no key, or none does.
  [[nodiscard]] static Result<TrustedKeys> load(const std::filesystem::path& file);
  /// Reads the text of such a file. `file` is what errors call it. Errors: as load().
  [[nodiscard]] static Result<TrustedKeys> read(std::string_view text, const std::string& file);

  /// Returns the key with this id, or null if it is not trusted.
  [[nodiscard]] const Trusted* find(std::string_view id) const noexcept;
  /// Returns all of them, in the order of the file; at least one.
  [[nodiscard]] const std::vector<Trusted>& all() const noexcept { return keys_; }

 private:
  std::vector<Trusted> keys_;
};

}  // namespace galilean
