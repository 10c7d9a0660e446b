// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/authority.h"

#include <openssl/pem.h>
#include <openssl/pkcs7.h>
#include <openssl/rand.h>
#include <openssl/sha.h>

#include <array>
#include <ctime>
#include <memory>
#include <span>
#include <utility>

#include "core/hexadecimal.h"
#include "core/private_file.h"
#include "core/regular_file.h"
#include "core/wire/authentication/subject_prefix.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;

using SignedDocument = std::unique_ptr<PKCS7, openssl::Free<PKCS7_free>>;
using RevokedList = std::unique_ptr<X509_CRL, openssl::Free<X509_CRL_free>>;
using RevokedEntry = std::unique_ptr<X509_REVOKED, openssl::Free<X509_REVOKED_free>>;
using Number = std::unique_ptr<BIGNUM, openssl::Free<BN_free>>;
using Integer = std::unique_ptr<ASN1_INTEGER, openssl::Free<ASN1_INTEGER_free>>;
using TimeValue = std::unique_ptr<ASN1_TIME, openssl::Free<ASN1_TIME_free>>;

constexpr std::uintmax_t kMostPemBytes = 1 << 20;
constexpr std::int64_t kDay_s = 24 * 3600;
constexpr std::int64_t kAuthoritysDays = 3650;
constexpr std::size_t kRandomBytes = 8;

/// Of a CA, and of a member, whose certificate signs no other.
constexpr const char* kAuthorityUse = "critical,keyCertSign,cRLSign,digitalSignature";
constexpr const char* kMemberUse = "critical,digitalSignature,keyAgreement";

Error failed(const std::string& what) {
  return Error{what + " cannot be made: " + openssl::last_problem()};
}

std::int64_t now_s() {
  return static_cast<std::int64_t>(std::time(nullptr));
}

/// Names the certificate's subject, with random digits, and derives the serial number from it.
/// Returns the serial number, or an empty text if OpenSSL fails.
std::string set_subject(X509& certificate, const std::string& name) {
  std::array<unsigned char, kRandomBytes> random{};
  X509_NAME* subject = X509_get_subject_name(&certificate);
  if (RAND_bytes(random.data(), static_cast<int>(random.size())) != 1 ||
      !openssl::add_field(subject, "CN", name) ||
      !openssl::add_field(subject, "OU", hexadecimal(random)))
    return {};
  unsigned char* encoded = nullptr;
  const int size = i2d_X509_NAME(subject, &encoded);
  if (size <= 0) return {};
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(encoded, static_cast<std::size_t>(size), digest.data());
  OPENSSL_free(encoded);
  const Number number(BN_bin2bn(digest.data(), static_cast<int>(wire::kSerialBytes), nullptr));
  if (!number || !BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(&certificate))) return {};
  return hexadecimal(std::span(digest).first(wire::kSerialBytes));
}

bool set_times(X509& certificate, std::int64_t until_s) {
  return ASN1_TIME_set(X509_getm_notBefore(&certificate), now_s() - kDay_s) != nullptr &&
         ASN1_TIME_set(X509_getm_notAfter(&certificate), until_s) != nullptr;
}

std::string subject_text(X509& certificate) {
  const openssl::Bio memory(BIO_new(BIO_s_mem()));
  if (!memory ||
      X509_NAME_print_ex(memory.get(), X509_get_subject_name(&certificate), 0, XN_FLAG_RFC2253) < 0)
    return {};
  return openssl::text_in(*memory);
}

/// Errors: as read_regular_file(). The sentence names the file.
Result<openssl::Bio> open_pem(const fs::path& file, std::string& text) {
  auto read = read_regular_file(file.string(), kMostPemBytes);
  if (!read) return Error{file.string() + " cannot be read: " + read.error().message};
  text = std::move(read).value();
  openssl::Bio memory(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  if (!memory) return failed("a copy of " + file.string());
  return memory;
}

bool add_revoked(X509_CRL& list, const std::string& serial, const ASN1_TIME& since) {
  BIGNUM* digits = nullptr;
  BN_hex2bn(&digits, serial.c_str());
  const Number number(digits);
  const Integer integer(number ? BN_to_ASN1_INTEGER(number.get(), nullptr) : nullptr);
  RevokedEntry entry(X509_REVOKED_new());
  const bool done =
      integer && entry && X509_REVOKED_set_serialNumber(entry.get(), integer.get()) == 1 &&
      X509_REVOKED_set_revocationDate(entry.get(), const_cast<ASN1_TIME*>(&since)) == 1 &&
      X509_CRL_add0_revoked(&list, entry.get()) == 1;
  if (done) static_cast<void>(entry.release());  // the list owns it now
  return done;
}

}  // namespace

Result<Authority> Authority::make(const std::string& name) {
  auto key = openssl::make_key();
  openssl::Certificate certificate(X509_new());
  if (!key || !certificate) return failed("the " + name);
  X509& made = *certificate;
  const bool done = X509_set_version(&made, 2) == 1 &&  // that is version 3
                    !set_subject(made, name).empty() &&
                    X509_set_issuer_name(&made, X509_get_subject_name(&made)) == 1 &&
                    set_times(made, now_s() + kAuthoritysDays * kDay_s) &&
                    X509_set_pubkey(&made, key.get()) == 1 &&
                    openssl::add_extension(made, made, NID_basic_constraints, "critical,CA:TRUE") &&
                    openssl::add_extension(made, made, NID_key_usage, kAuthorityUse) &&
                    X509_sign(&made, key.get(), EVP_sha256()) != 0;
  if (!done) return failed("the " + name);
  return Authority(std::move(key), std::move(certificate));
}

Result<Authority> Authority::read(const fs::path& certificate, const fs::path& key) {
  std::string certificate_text, key_text;
  const auto certificate_memory = open_pem(certificate, certificate_text);
  if (!certificate_memory) return certificate_memory.error();
  const auto key_memory = open_pem(key, key_text);
  if (!key_memory) return key_memory.error();
  openssl::Certificate read_certificate(
      PEM_read_bio_X509(certificate_memory.value().get(), nullptr, nullptr, nullptr));
  if (!read_certificate)
    return Error{certificate.string() + " has no certificate in PEM: " + openssl::last_problem()};
  openssl::Key read_key(
      PEM_read_bio_PrivateKey(key_memory.value().get(), nullptr, nullptr, nullptr));
  if (!read_key)
    return Error{key.string() + " has no private key in PEM: " + openssl::last_problem()};
  if (X509_check_private_key(read_certificate.get(), read_key.get()) != 1)
    return Error{key.string() + " is not the key of " + certificate.string()};
  return Authority(std::move(read_key), std::move(read_certificate));
}

Result<void> Authority::write(const fs::path& certificate, const fs::path& key) const {
  const auto key_text = openssl::pem_of(*key_), text = openssl::pem_of(*certificate_);
  if (key_text.empty() || text.empty()) return failed(certificate.string());
  if (auto written = replace_private_file(key, key_text); !written) return written;
  return replace_private_file(certificate, text);
}

Result<IssuedIdentity> Authority::issue(const std::string& name, std::int64_t until_s) const {
  const auto key = openssl::make_key();
  const openssl::Certificate certificate(X509_new());
  if (!key || !certificate) return failed("the certificate of " + name);
  X509& made = *certificate;
  IssuedIdentity issued;
  issued.serial = X509_set_version(&made, 2) == 1 ? set_subject(made, name) : std::string();
  const bool done =
      !issued.serial.empty() &&
      X509_set_issuer_name(&made, X509_get_subject_name(certificate_.get())) == 1 &&
      set_times(made, until_s) && X509_set_pubkey(&made, key.get()) == 1 &&
      openssl::add_extension(made, *certificate_, NID_basic_constraints, "critical,CA:FALSE") &&
      openssl::add_extension(made, *certificate_, NID_key_usage, kMemberUse) &&
      X509_sign(&made, key_.get(), EVP_sha256()) != 0;
  issued.certificate = done ? openssl::pem_of(made) : std::string();
  issued.key = openssl::pem_of(*key);
  issued.subject = subject_text(made);
  if (issued.certificate.empty() || issued.key.empty() || issued.subject.empty())
    return failed("the certificate of " + name);
  return issued;
}

Result<std::string> Authority::sign(const std::string& document) const {
  constexpr int kFlags = PKCS7_DETACHED | PKCS7_TEXT | PKCS7_STREAM;
  const openssl::Bio text(BIO_new_mem_buf(document.data(), static_cast<int>(document.size())));
  const openssl::Bio signed_text(BIO_new(BIO_s_mem()));
  if (!text || !signed_text) return failed("a signature");
  const SignedDocument made(
      PKCS7_sign(certificate_.get(), key_.get(), nullptr, text.get(), kFlags));
  if (!made || SMIME_write_PKCS7(signed_text.get(), made.get(), text.get(), kFlags) != 1)
    return failed("a signature");
  return openssl::text_in(*signed_text);
}

Result<std::string> Authority::revoked_list(const std::vector<std::string>& serials) const {
  const RevokedList list(X509_CRL_new());
  const TimeValue since(ASN1_TIME_set(nullptr, now_s() - kDay_s));
  bool done =
      list && since && X509_CRL_set_version(list.get(), 1) == 1 &&  // that is version 2
      X509_CRL_set_issuer_name(list.get(), X509_get_subject_name(certificate_.get())) == 1 &&
      X509_CRL_set1_lastUpdate(list.get(), since.get()) == 1 &&
      X509_CRL_set1_nextUpdate(list.get(), X509_get0_notAfter(certificate_.get())) == 1;
  for (const auto& serial : serials) done = done && add_revoked(*list, serial, *since);
  done = done && X509_CRL_sort(list.get()) == 1 &&
         X509_CRL_sign(list.get(), key_.get(), EVP_sha256()) != 0;
  const openssl::Bio memory(BIO_new(BIO_s_mem()));
  if (!done || !memory || PEM_write_bio_X509_CRL(memory.get(), list.get()) != 1)
    return failed("the list of revoked certificates");
  return openssl::text_in(*memory);
}

}  // namespace galilean::monitor
