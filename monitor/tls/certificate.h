// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

struct x509_st;  // OpenSSL's X509

namespace galilean::monitor {

/// A certificate and its private key, each as a PEM file.
struct CertificateFiles {
  std::filesystem::path certificate, key;
};

/// Returns the files of the certificate that a monitor makes for itself in its data folder.
[[nodiscard]] CertificateFiles own_certificate(const std::filesystem::path& data_folder);

/// Makes a self-signed certificate, for this machine's names and addresses, with a key for its
/// owner alone (mode 0600). Leaves files that are there, unless the certificate is over. Errors:
/// the files cannot be read or written.
[[nodiscard]] Result<void> ensure_own_certificate(const CertificateFiles& files);

/// Returns a certificate's SHA-256, as browsers show it: 32 bytes as "AB:CD:…".
[[nodiscard]] std::string fingerprint_of(const x509_st& certificate);
/// Returns that of the first certificate in a PEM file. Errors: there is none.
[[nodiscard]] Result<std::string> fingerprint_of(const std::filesystem::path& certificate_file);

/// Returns a fingerprint as fingerprint_of() writes it, of one that a person copied: letters of
/// either case, with colons, blanks or nothing between the bytes.
/// Errors: it is not 32 bytes in hexadecimal digits.
[[nodiscard]] Result<std::string> read_fingerprint(const std::string& text);

}  // namespace galilean::monitor
