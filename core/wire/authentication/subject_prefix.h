// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace galilean::wire {

/// A certificate's serial number in Galilean: the first bytes of the SHA-256 of its subject.
inline constexpr std::size_t kSerialBytes = 16;

/// The bytes of a participant's GUID that DDS Security 1.1, 9.3.3, derives from its certificate's
/// subject: peers refuse a participant whose GUID and certificate differ.
using SubjectPrefix = std::array<std::uint8_t, 6>;

/// Returns that prefix from the SHA-256 of the subject, or from its beginning: a bit that is set,
/// and the digest's first 47 bits. Requires: six bytes or more.
[[nodiscard]] constexpr SubjectPrefix subject_prefix(
    std::span<const std::uint8_t> digest) noexcept {
  SubjectPrefix prefix{};
  unsigned carried = 0x80;
  for (std::size_t i = 0; i < prefix.size(); ++i) {
    prefix[i] = static_cast<std::uint8_t>(carried | (digest[i] >> 1U));
    carried = (static_cast<unsigned>(digest[i]) << 7U) & 0x80U;
  }
  return prefix;
}

}  // namespace galilean::wire
