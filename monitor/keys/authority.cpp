// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/authority.h"

#include <openssl/pem.h>
#include <openssl/pkcs7.h>
#include <openssl/rand.h>
#include <openssl/sha.h>

#include <array>
#include <ctime>
#include <memory>
#include <utility>

#include "core/private_file.h"
#include "core/regular_file.h"
#include "core/wire/authentication/subject_prefix.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;

using SignedDocument = std::unique_ptr<PKCS7, openssl::Freeing<PKCS7_free>>;
using RevokedList = std::unique_ptr<X509_CRL, openssl::Freeing<X509_CRL_free>>;
using RevokedEntry = std::unique_ptr<X509_REVOKED, openssl::Freeing<X509_REVOKED_free>>;
using Number = std::unique_ptr<BIGNUM, openssl::Freeing<BN_free>>;
using Integer = std::unique_ptr<ASN1_INTEGER, openssl::Freeing<ASN1_INTEGER_free>>;
using TimeValue = std::unique_ptr<ASN1_TIME, openssl::Freeing<ASN1_TIME_free>>;

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

std::string hexadecimal_of(const unsigned char* bytes, std::size_t count) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    (text += kDigits[bytes[i] >> 4U]) += kDigits[bytes[i] & 15U];
  return text;
}

std::string text_of_memory(BIO* memory) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(memory, &data);
  return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string();
}

bool add_name(X509_NAME* name, const char* field, const std::string& text) {
  return X509_NAME_add_entry_by_txt(name, field, MBSTRING_UTF8,
                                    reinterpret_cast<const unsigned char*>(text.data()),
                                    static_cast<int>(text.size()), -1, 0) == 1;
}

/// Names the certificate's subject, with random digits, and derives the serial number from it.
/// Returns the serial number, or an empty text if OpenSSL fails.
std::string set_subject(X509& certificate, const std::string& name) {
  std::array<unsigned char, kRandomBytes> random{};
  X509_NAME* subject = X509_get_subject_name(&certificate);
  if (RAND_bytes(random.data(), static_cast<int>(random.size())) != 1 ||
      !add_name(subject, "CN", name) ||
      !add_name(subject, "OU", hexadecimal_of(random.data(), random.size())))
    return {};
  unsigned char* encoded = nullptr;
  const int size = i2d_X509_NAME(subject, &encoded);
  if (size <= 0) return {};
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(encoded, static_cast<std::size_t>(size), digest.data());
  OPENSSL_free(encoded);
  const Number number(BN_bin2bn(digest.data(), static_cast<int>(wire::kSerialBytes), nullptr));
  if (!number || !BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(&certificate))) return {};
  return hexadecimal_of(digest.data(), wire::kSerialBytes);
}

bool set_times(X509& certificate, std::int64_t until_s) {
  return ASN1_TIME_set(X509_getm_notBefore(&certificate), now_s() - kDay_s) != nullptr &&
         ASN1_TIME_set(X509_getm_notAfter(&certificate), until_s) != nullptr;
}

bool add_extension_of(X509& certificate, X509& issuer, int kind, const char* value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, &issuer, &certificate, nullptr, nullptr, 0);
  const openssl::Extension extension(X509V3_EXT_conf_nid(nullptr, &context, kind, value));
  return extension && X509_add_ext(&certificate, extension.get(), -1) == 1;
}

std::string subject_text(X509& certificate) {
  const openssl::Memory memory(BIO_new(BIO_s_mem()));
  if (!memory ||
      X509_NAME_print_ex(memory.get(), X509_get_subject_name(&certificate), 0, XN_FLAG_RFC2253) < 0)
    return {};
  return text_of_memory(memory.get());
}

std::string pem_of_certificate(X509& certificate) {
  const openssl::Memory memory(BIO_new(BIO_s_mem()));
  return memory && PEM_write_bio_X509(memory.get(), &certificate) == 1
             ? text_of_memory(memory.get())
             : std::string();
}

std::string pem_of_key(EVP_PKEY& key) {
  const openssl::Memory memory(BIO_new(BIO_s_mem()));
  return memory && PEM_write_bio_PrivateKey(memory.get(), &key, nullptr, nullptr, 0, nullptr,
                                            nullptr) == 1
             ? text_of_memory(memory.get())
             : std::string();
}

openssl::Key new_key() {
  return openssl::Key(EVP_PKEY_Q_keygen(nullptr, nullptr, "EC", "P-256"));
}

/// Errors: as read_regular_file(). The sentence names the file.
Result<openssl::Memory> open_pem(const fs::path& file, std::string& text) {
  auto read = read_regular_file(file.string(), kMostPemBytes);
  if (!read) return Error{file.string() + " cannot be read: " + read.error().message};
  text = std::move(read).value();
  openssl::Memory memory(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
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
  auto key = new_key();
  openssl::Certificate certificate(X509_new());
  if (!key || !certificate) return failed("the " + name);
  X509& made = *certificate;
  const bool done = X509_set_version(&made, 2) == 1 &&  // that is version 3
                    !set_subject(made, name).empty() &&
                    X509_set_issuer_name(&made, X509_get_subject_name(&made)) == 1 &&
                    set_times(made, now_s() + kAuthoritysDays * kDay_s) &&
                    X509_set_pubkey(&made, key.get()) == 1 &&
                    add_extension_of(made, made, NID_basic_constraints, "critical,CA:TRUE") &&
                    add_extension_of(made, made, NID_key_usage, kAuthorityUse) &&
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
  const auto key_text = pem_of_key(*key_), text = pem_of_certificate(*certificate_);
  if (key_text.empty() || text.empty()) return failed(certificate.string());
  if (auto written = replace_private_file(key, key_text); !written) return written;
  return replace_private_file(certificate, text);
}

Result<IssuedIdentity> Authority::issue(const std::string& name, std::int64_t until_s) const {
  const auto key = new_key();
  const openssl::Certificate certificate(X509_new());
  if (!key || !certificate) return failed("the certificate of " + name);
  X509& made = *certificate;
  IssuedIdentity issued;
  issued.serial = X509_set_version(&made, 2) == 1 ? set_subject(made, name) : std::string();
  const bool done =
      !issued.serial.empty() &&
      X509_set_issuer_name(&made, X509_get_subject_name(certificate_.get())) == 1 &&
      set_times(made, until_s) && X509_set_pubkey(&made, key.get()) == 1 &&
      add_extension_of(made, *certificate_, NID_basic_constraints, "critical,CA:FALSE") &&
      add_extension_of(made, *certificate_, NID_key_usage, kMemberUse) &&
      X509_sign(&made, key_.get(), EVP_sha256()) != 0;
  issued.certificate = done ? pem_of_certificate(made) : std::string();
  issued.key = pem_of_key(*key);
  issued.subject = subject_text(made);
  if (issued.certificate.empty() || issued.key.empty() || issued.subject.empty())
    return failed("the certificate of " + name);
  return issued;
}

Result<std::string> Authority::sign(const std::string& document) const {
  constexpr int kFlags = PKCS7_DETACHED | PKCS7_TEXT | PKCS7_STREAM;
  const openssl::Memory text(BIO_new_mem_buf(document.data(), static_cast<int>(document.size())));
  const openssl::Memory signed_text(BIO_new(BIO_s_mem()));
  if (!text || !signed_text) return failed("a signature");
  const SignedDocument made(
      PKCS7_sign(certificate_.get(), key_.get(), nullptr, text.get(), kFlags));
  if (!made || SMIME_write_PKCS7(signed_text.get(), made.get(), text.get(), kFlags) != 1)
    return failed("a signature");
  return text_of_memory(signed_text.get());
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
  const openssl::Memory memory(BIO_new(BIO_s_mem()));
  if (!done || !memory || PEM_write_bio_X509_CRL(memory.get(), list.get()) != 1)
    return failed("the list of revoked certificates");
  return text_of_memory(memory.get());
}

}  // namespace galilean::monitor
