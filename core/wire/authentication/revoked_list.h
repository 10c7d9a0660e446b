// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <openssl/pem.h>
#include <openssl/sha.h>
#include <openssl/x509.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "core/openssl.h"
#include "core/wire/authentication/subject_prefix.h"

namespace galilean::wire {

/// The members that a list of revoked certificates names.
using RevokedMembers = std::set<SubjectPrefix>;

// Everything here is inline, for the module, which is linked with none of Galilean's libraries, and
// for tests of lists.

/// Reads a PEM file by one of OpenSSL's readers. Returns null if it cannot be read.
template <class T, auto free_it, class Read>
std::unique_ptr<T, openssl::Free<free_it>> read_pem(const std::string& file, Read read) {
  const openssl::Bio bio(BIO_new_file(file.c_str(), "r"));
  return std::unique_ptr<T, openssl::Free<free_it>>(bio ? read(bio.get(), nullptr, nullptr, nullptr)
                                                        : nullptr);
}

inline std::optional<SubjectPrefix> prefix_of_serial(const ASN1_INTEGER* serial) {
  const std::unique_ptr<BIGNUM, openssl::Free<BN_free>> number(ASN1_INTEGER_to_BN(serial, nullptr));
  std::array<std::uint8_t, kSerialBytes> bytes{};
  if (!number || BN_bn2binpad(number.get(), bytes.data(), static_cast<int>(bytes.size())) < 0)
    return {};
  return subject_prefix(bytes);
}

/// Returns the prefix of the participant whose certificate, in PEM, this is; nothing if it is none.
inline std::optional<SubjectPrefix> prefix_of_certificate(std::span<const std::uint8_t> pem) {
  const openssl::Bio bio(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
  const std::unique_ptr<X509, openssl::Free<X509_free>> certificate(
      bio ? PEM_read_bio_X509(bio.get(), nullptr, nullptr, nullptr) : nullptr);
  if (!certificate) return {};
  unsigned char* encoded = nullptr;
  const int size = i2d_X509_NAME(X509_get_subject_name(certificate.get()), &encoded);
  if (size <= 0) return {};
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest{};
  SHA256(encoded, static_cast<std::size_t>(size), digest.data());
  OPENSSL_free(encoded);
  return subject_prefix(digest);
}

/// Returns the members that a list names, or nothing if it cannot be read or is not signed by that
/// CA. `list_file` and `ca_file` are PEM.
inline std::optional<RevokedMembers> read_revoked(const std::string& list_file,
                                                  const std::string& ca_file) {
  const auto ca = read_pem<X509, X509_free>(ca_file, PEM_read_bio_X509);
  const auto list = read_pem<X509_CRL, X509_CRL_free>(list_file, PEM_read_bio_X509_CRL);
  EVP_PKEY* key = ca ? X509_get0_pubkey(ca.get()) : nullptr;
  if (!list || !key || X509_CRL_verify(list.get(), key) != 1) return {};
  RevokedMembers members;
  auto* entries = X509_CRL_get_REVOKED(list.get());
  for (int i = 0; entries != nullptr && i < sk_X509_REVOKED_num(entries); ++i) {
    const auto* serial = X509_REVOKED_get0_serialNumber(sk_X509_REVOKED_value(entries, i));
    if (const auto prefix = prefix_of_serial(serial)) members.insert(*prefix);
  }
  return members;
}

}  // namespace galilean::wire
