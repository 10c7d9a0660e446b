// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/result.h"

namespace galilean {

/// The public half of an Ed25519 key (RFC 8032), by which anybody can verify a signature.
class VerifyingKey {
 public:
  static constexpr std::size_t kBytes = 32;
  using Bytes = std::array<std::uint8_t, kBytes>;

  explicit VerifyingKey(const Bytes& bytes) : bytes_(bytes) {}
  /// Reads the base64 that text() gives. Errors: that is no base64 of 32 bytes.
  [[nodiscard]] static Result<VerifyingKey> from_text(std::string_view text);

  /// Returns the key as base64, 44 characters.
  [[nodiscard]] std::string text() const;
  /// Returns what messages name the key by: the first 16 hexadecimal digits of its SHA-256.
  /// Errors: throws std::runtime_error if OpenSSL cannot compute it.
  [[nodiscard]] std::string id() const;
  /// Returns whether `signature` is this key's signature of `message`.
  [[nodiscard]] bool verify(std::span<const std::uint8_t> message,
                            std::span<const std::uint8_t> signature) const;

  [[nodiscard]] const Bytes& bytes() const noexcept { return bytes_; }
  bool operator==(const VerifyingKey&) const = default;

 private:
  Bytes bytes_;
};

}  // namespace galilean
