// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/signing/verifying_key.h"

namespace galilean {

/// Returns the line that names a public key in a file of trusted keys, with its line feed:
/// "ed25519 BASE64 NAME". Characters of the name that would end the line become spaces.
[[nodiscard]] std::string trust_line(const VerifyingKey& key, const std::string& name);

/// Returns the first key in a file of trusted keys, or nothing if there is none.
[[nodiscard]] std::optional<VerifyingKey> first_key_in(const std::filesystem::path& file);

}  // namespace galilean
