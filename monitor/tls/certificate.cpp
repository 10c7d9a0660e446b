// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/tls/certificate.h"

#include <openssl/pem.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <utility>

#include "core/private_file.h"
#include "core/regular_file.h"
#include "core/visible_text.h"
#include "monitor/tls/openssl.h"
#include "monitor/tls/own_addresses.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostPemBytes = 1 << 20;
constexpr long kDay_s = 24 * 3600;
/// The longest that all browsers accept of a certificate that a person trusts by hand.
constexpr long kValidFor_s = 825 * kDay_s;
constexpr std::size_t kFingerprintBytes = 32;

Error unmade(const CertificateFiles& files) {
  return Error{"no certificate can be made for " + files.certificate.string() + ": " +
               openssl::last_problem()};
}

/// Returns the names by which this machine is reached, as OpenSSL's configuration writes them.
std::string alternative_names() {
  std::string names = "DNS:localhost";
  if (const auto host = own_host_name(); !host.empty() && host != "localhost")
    names += ",DNS:" + host;
  auto addresses = own_addresses();
  for (const char* loopback : {"127.0.0.1", "::1"})
    if (std::ranges::find(addresses, loopback) == addresses.end()) addresses.push_back(loopback);
  for (const auto& address : addresses) names += ",IP:" + address;
  return names;
}

bool set_serial_and_name(X509& certificate) {
  std::array<unsigned char, 8> random{};
  if (RAND_bytes(random.data(), static_cast<int>(random.size())) != 1) return false;
  std::uint64_t serial = 0;
  for (const auto byte : random) serial = serial << 8 | byte;
  X509_NAME* name = X509_get_subject_name(&certificate);
  return ASN1_INTEGER_set_uint64(X509_get_serialNumber(&certificate), serial >> 1) == 1 &&
         openssl::add_field(name, "CN", "galilean-monitor") &&
         X509_set_issuer_name(&certificate, name) == 1;
}

/// Returns nothing, with the reason in OpenSSL's queue, if it fails.
openssl::Certificate signed_by_itself(EVP_PKEY& key) {
  openssl::Certificate certificate(X509_new());
  if (!certificate) return {};
  X509& made = *certificate;
  const bool done =
      X509_set_version(&made, 2) == 1 &&  // that is version 3
      set_serial_and_name(made) &&
      X509_gmtime_adj(X509_getm_notBefore(&made), -kDay_s) != nullptr &&  // clocks differ
      X509_gmtime_adj(X509_getm_notAfter(&made), kValidFor_s - kDay_s) != nullptr &&
      X509_set_pubkey(&made, &key) == 1 &&
      openssl::add_extension(made, made, NID_basic_constraints, "critical,CA:FALSE") &&
      openssl::add_extension(made, made, NID_ext_key_usage, "serverAuth") &&
      openssl::add_extension(made, made, NID_subject_alt_name, alternative_names()) &&
      X509_sign(&made, &key, EVP_sha256()) != 0;
  return done ? std::move(certificate) : openssl::Certificate();
}

Result<void> make_own(const CertificateFiles& files) {
  const auto key = openssl::make_key();
  if (!key) return unmade(files);
  const auto certificate = signed_by_itself(*key);
  if (!certificate) return unmade(files);
  const auto key_text = openssl::pem_of(*key), text = openssl::pem_of(*certificate);
  if (key_text.empty() || text.empty()) return unmade(files);
  if (auto made = make_private_folder(files.key.parent_path()); !made) return made;
  if (auto written = replace_private_file(files.key, key_text); !written) return written;
  return replace_private_file(files.certificate, text);
}

Result<openssl::Certificate> read_certificate(const fs::path& file) {
  const auto text = read_regular_file(file.string(), kMostPemBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  const openssl::Bio memory(
      BIO_new_mem_buf(text.value().data(), static_cast<int>(text.value().size())));
  openssl::Certificate certificate(
      memory ? PEM_read_bio_X509(memory.get(), nullptr, nullptr, nullptr) : nullptr);
  if (!certificate)
    return Error{file.string() + " has no certificate in PEM: " + openssl::last_problem()};
  return certificate;
}

}  // namespace

CertificateFiles own_certificate(const fs::path& data_folder) {
  return {data_folder / "certificate.pem", data_folder / "certificate.key"};
}

Result<void> ensure_own_certificate(const CertificateFiles& files) {
  std::error_code unknown;
  if (!fs::exists(files.certificate, unknown) || !fs::exists(files.key, unknown))
    return make_own(files);
  const auto certificate = read_certificate(files.certificate);
  if (!certificate)
    return Error{certificate.error().message + "; remove it, and the monitor makes a new one"};
  const bool is_over = X509_cmp_current_time(X509_get0_notAfter(certificate.value().get())) < 0;
  return is_over ? make_own(files) : Result<void>();
}

std::string fingerprint_of(const x509_st& certificate) {
  static constexpr char kDigits[] = "0123456789ABCDEF";
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (X509_digest(&certificate, EVP_sha256(), digest.data(), &size) != 1) return {};
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    if (i > 0) text += ':';
    (text += kDigits[digest[i] >> 4]) += kDigits[digest[i] & 15];
  }
  return text;
}

Result<std::string> fingerprint_of(const fs::path& certificate_file) {
  const auto certificate = read_certificate(certificate_file);
  if (!certificate) return certificate.error();
  return fingerprint_of(*certificate.value());
}

Result<std::string> read_fingerprint(const std::string& text) {
  std::string digits;
  for (const char letter : text)
    if (letter != ':' && letter != ' ')
      digits += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  if (digits.size() != 2 * kFingerprintBytes ||
      digits.find_first_not_of("0123456789ABCDEF") != std::string::npos)
    return Error{"'" + visible(text) +
                 "' is not a valid SHA-256 fingerprint, which has 64 hexadecimal digits"};
  std::string fingerprint;
  for (std::size_t at = 0; at < digits.size(); at += 2)
    fingerprint += (at > 0 ? ":" : "") + digits.substr(at, 2);
  return fingerprint;
}

}  // namespace galilean::monitor
