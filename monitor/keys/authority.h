// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/tls/openssl.h"

namespace galilean::monitor {

/// A member's new certificate. Texts of files are PEM.
struct IssuedIdentity {
  std::string certificate, key;
  std::string subject;  ///< as RFC 2253 writes it, and grants name it
  std::string serial;   ///< 32 hexadecimal digits, by which the certificate is revoked
};

/// Somebody whose signature a team trusts: a key of the curve P-256, and a certificate that it
/// signed itself, valid for ten years.
class Authority {
 public:
  /// `name` stands in the certificate, with random digits that tell it from those of other teams.
  /// Errors: OpenSSL fails.
  [[nodiscard]] static Result<Authority> make(const std::string& name);
  /// Errors: a file cannot be read, or holds no such thing. The sentence names it.
  [[nodiscard]] static Result<Authority> read(const std::filesystem::path& certificate,
                                              const std::filesystem::path& key);
  /// Writes both as PEM, for their owner alone (mode 0600). Errors: as replace_private_file().
  [[nodiscard]] Result<void> write(const std::filesystem::path& certificate,
                                   const std::filesystem::path& key) const;

  /// Makes a key and a certificate for a member, valid from yesterday, because clocks differ, until
  /// `until_s` [s since 1970]. The subject has random digits, so that the same name never is the
  /// same member twice; the serial number is the beginning of the subject's SHA-256. Errors:
  /// OpenSSL fails.
  [[nodiscard]] Result<IssuedIdentity> issue(const std::string& name, std::int64_t until_s) const;

  /// Returns the document signed as S/MIME, as DDS Security 1.1, 9.4.1.1, wants it: the text in
  /// clear, and the signature behind it. Errors: OpenSSL fails.
  [[nodiscard]] Result<std::string> sign(const std::string& document) const;

  /// Returns the list of revoked certificates, as PEM, valid as long as this authority. `serials`
  /// are as IssuedIdentity::serial. Errors: OpenSSL fails.
  [[nodiscard]] Result<std::string> revoked_list(const std::vector<std::string>& serials) const;

 private:
  Authority(openssl::Key key, openssl::Certificate certificate)
      : key_(std::move(key)), certificate_(std::move(certificate)) {}

  openssl::Key key_;
  openssl::Certificate certificate_;
};

}  // namespace galilean::monitor
