// SPDX-License-Identifier: BSD-3-Clause
#include "core/signing/signing_key.h"

#include <openssl/pem.h>
#include <sys/stat.h>

#include <optional>

#include "core/private_file.h"
#include "core/regular_file.h"
#include "core/signing/key_files.h"
#include "core/signing/openssl.h"

namespace galilean {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSignatureBytes = 64;
constexpr std::uintmax_t kMostKeyBytes = 64 * 1024;

Error no_ed25519() {
  return Error{"OpenSSL has no Ed25519 on this machine; it needs OpenSSL 1.1.1 or later"};
}

openssl::Key secret_of(const SigningKey::Seed& seed) {
  return openssl::Key(
      EVP_PKEY_new_raw_private_key(EVP_PKEY_ED25519, nullptr, seed.data(), seed.size()));
}

/// Without it OpenSSL would ask for a password on the terminal.
int give_no_password(char* /*password*/, int /*size*/, int /*writes*/, void* /*user*/) {
  return -1;
}

/// Returns the seed of a key in PEM, or nothing if the text holds no Ed25519 key.
std::optional<SigningKey::Seed> seed_in(const std::string& pem) {
  const openssl::Bio source(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
  if (!source) return std::nullopt;
  const openssl::Key key(PEM_read_bio_PrivateKey(source.get(), nullptr, give_no_password, nullptr));
  if (!key || EVP_PKEY_get_id(key.get()) != EVP_PKEY_ED25519) return std::nullopt;
  SigningKey::Seed seed{};
  std::size_t size = seed.size();
  if (EVP_PKEY_get_raw_private_key(key.get(), seed.data(), &size) != 1 || size != seed.size())
    return std::nullopt;
  return seed;
}

/// Returns the key in PEM, or an empty text if OpenSSL cannot write it.
std::string pem_of(const SigningKey::Seed& seed) {
  const openssl::Key key = secret_of(seed);
  const openssl::Bio sink(BIO_new(BIO_s_mem()));
  if (!key || !sink ||
      PEM_write_bio_PrivateKey(sink.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) != 1)
    return {};
  char* text = nullptr;
  const long size = BIO_get_mem_data(sink.get(), &text);
  return {text, static_cast<std::size_t>(size)};
}

Result<void> check_mode(const fs::path& file) {
  struct stat status {};
  constexpr mode_t kOfOthers = S_IRWXG | S_IRWXO;
  if (stat(file.c_str(), &status) == 0 && (status.st_mode & kOfOthers) != 0)
    return Error{file.string() +
                 " can be used by others than its owner: make a new key, or run 'chmod 600 " +
                 file.string() + "' if nobody has read it"};
  return {};
}

}  // namespace

Result<SigningKey> SigningKey::make() {
  const openssl::KeyContext context(EVP_PKEY_CTX_new_id(EVP_PKEY_ED25519, nullptr));
  EVP_PKEY* made = nullptr;
  if (!context || EVP_PKEY_keygen_init(context.get()) != 1 ||
      EVP_PKEY_keygen(context.get(), &made) != 1)
    return no_ed25519();
  const openssl::Key key(made);
  Seed seed{};
  std::size_t size = seed.size();
  if (EVP_PKEY_get_raw_private_key(key.get(), seed.data(), &size) != 1) return no_ed25519();
  return from_seed(seed);
}

Result<SigningKey> SigningKey::from_seed(const Seed& seed) {
  const openssl::Key key = secret_of(seed);
  VerifyingKey::Bytes bytes{};
  std::size_t size = bytes.size();
  if (!key || EVP_PKEY_get_raw_public_key(key.get(), bytes.data(), &size) != 1) return no_ed25519();
  return SigningKey(seed, VerifyingKey(bytes));
}

Result<SigningKey> SigningKey::load(const fs::path& file) {
  const auto text = read_regular_file(file.string(), kMostKeyBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  if (const auto safe = check_mode(file); !safe) return safe.error();
  const auto seed = seed_in(text.value());
  if (!seed)
    return Error{
        file.string() +
        " holds no Ed25519 key in PEM without a password; where it is removed, 'galilean keys' "
        "makes a new one, which robots must be told to trust"};
  return from_seed(*seed);
}

Result<void> SigningKey::save(const fs::path& file, const std::string& name) const {
  const std::string pem = pem_of(seed_);
  if (pem.empty()) return no_ed25519();
  if (auto written = write_new_file(file, pem, 0600); !written) return written;
  return write_new_file(public_key_file(file), trust_line(verifying_key(), name), 0644);
}

Result<std::vector<std::uint8_t>> SigningKey::sign(std::span<const std::uint8_t> message) const {
  const openssl::Key key = secret_of(seed_);
  const openssl::DigestContext context(EVP_MD_CTX_new());
  std::vector<std::uint8_t> signature(kSignatureBytes);
  std::size_t size = signature.size();
  if (!key || !context ||
      EVP_DigestSignInit(context.get(), nullptr, nullptr, nullptr, key.get()) != 1 ||
      EVP_DigestSign(context.get(), signature.data(), &size, message.data(), message.size()) != 1)
    return no_ed25519();
  signature.resize(size);
  return signature;
}

fs::path public_key_file(const fs::path& key_file) {
  return key_file.string() + ".pub";
}

Result<SigningKey> load_or_make_key(const fs::path& file, const std::string& name) {
  std::error_code unknown;
  if (!fs::exists(file, unknown)) {
    const auto made = SigningKey::make();
    if (!made) return made.error();
    // What fails is said when the key is written.
    (void)make_private_folder(file.parent_path());
    if (const auto saved = made.value().save(file, name); !saved) return saved.error();
  }
  auto key = SigningKey::load(file);
  if (!key) return key.error();
  // Another process may have made the key meanwhile. The public half must be that of the file.
  const fs::path beside = public_key_file(file);
  if (const auto told = first_key_in(beside); told && *told == key.value().verifying_key())
    return key;
  fs::remove(beside, unknown);
  const std::string line = trust_line(key.value().verifying_key(), name);
  if (const auto written = write_new_file(beside, line, 0644); !written) return written.error();
  return key;
}

}  // namespace galilean
