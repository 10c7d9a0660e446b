// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/signing/verifying_key.h"

namespace galilean {

/// The secret half of an Ed25519 key (RFC 8032). Any thread may sign with it.
class SigningKey {
 public:
  static constexpr std::size_t kBytes = 32;
  using Seed = std::array<std::uint8_t, kBytes>;

  /// Makes a new key. Errors: OpenSSL has no random numbers or no Ed25519 on this machine.
  [[nodiscard]] static Result<SigningKey> make();
  /// Returns the key that RFC 8032 derives from a seed. Errors: as make().
  [[nodiscard]] static Result<SigningKey> from_seed(const Seed& seed);
  /// Reads the file that save() wrote, or any Ed25519 key in PEM without a password.
  /// Errors: it cannot be read, holds no such key, or can be read by others than its owner.
  [[nodiscard]] static Result<SigningKey> load(const std::filesystem::path& file);

  /// Writes the key as PEM, readable by its owner only (mode 0600), and its public half into the
  /// file beside it, as public_key_file() names that, under `name`. A file that is there is not
  /// replaced. Its key is the valid one then. Errors: a file cannot be written.
  [[nodiscard]] Result<void> save(const std::filesystem::path& file, const std::string& name) const;

  /// Returns the 64 bytes of the signature. Errors: OpenSSL cannot sign on this machine.
  [[nodiscard]] Result<std::vector<std::uint8_t>> sign(std::span<const std::uint8_t> message) const;
  [[nodiscard]] const VerifyingKey& verifying_key() const noexcept { return public_half_; }

 private:
  SigningKey(const Seed& seed, const VerifyingKey& public_half)
      : seed_(seed), public_half_(public_half) {}

  Seed seed_;
  VerifyingKey public_half_;
};

/// Returns the file of the public half: that of the key with ".pub" behind it.
[[nodiscard]] std::filesystem::path public_key_file(const std::filesystem::path& key_file);

/// Reads the key, and makes it first if it is not there. The public half's file is written anew if
/// it is missing. Errors: as SigningKey::load() and SigningKey::save().
[[nodiscard]] Result<SigningKey> load_or_make_key(const std::filesystem::path& file,
                                                  const std::string& name);

}  // namespace galilean
