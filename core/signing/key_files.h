// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

#include "core/result.h"
#include "core/signing/verifying_key.h"

namespace galilean {

/// Returns the line that names a public key in a file of trusted keys, with its line feed:
/// "ed25519 BASE64 NAME". Characters of the name that would end the line become spaces.
[[nodiscard]] std::string trust_line(const VerifyingKey& key, const std::string& name);

/// Returns the first key in a file of trusted keys, or nothing if there is none.
[[nodiscard]] std::optional<VerifyingKey> first_key_in(const std::filesystem::path& file);

/// Writes the file whole or not at all, so that a crash never leaves half a key. A file that is
/// there stays as it is, which is no error. Errors: the file cannot be written.
[[nodiscard]] Result<void> write_new_file(const std::filesystem::path& file,
                                          const std::string& text, mode_t mode);

}  // namespace galilean
