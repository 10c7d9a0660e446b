// SPDX-License-Identifier: BSD-3-Clause
#include "core/signing/verifying_key.h"

#include <algorithm>
#include <stdexcept>

#include "core/hexadecimal.h"
#include "core/signing/openssl.h"

namespace galilean {
namespace {

constexpr std::size_t kBase64Size = 44;  // of 32 bytes, with one character of padding
constexpr std::size_t kIdBytes = 8;

}  // namespace

Result<VerifyingKey> VerifyingKey::from_text(std::string_view text) {
  const Error wrong{"a public key is 44 characters of base64, as in operator.key.pub"};
  // Base64 of 32 bytes ends in one '='. OpenSSL would take others, and lines of any length.
  if (text.size() != kBase64Size || text.find('=') != kBase64Size - 1) return wrong;
  std::array<unsigned char, kBytes + 1> decoded{};  // the padding decodes to one byte more
  const int size =
      EVP_DecodeBlock(decoded.data(), reinterpret_cast<const unsigned char*>(text.data()),
                      static_cast<int>(text.size()));
  if (size != static_cast<int>(decoded.size())) return wrong;
  Bytes bytes{};
  std::copy(decoded.begin(), decoded.begin() + kBytes, bytes.begin());
  // One key has one text: the bits that base64 leaves over must be zero.
  VerifyingKey key(bytes);
  if (key.text() != text) return wrong;
  return key;
}

std::string VerifyingKey::text() const {
  std::array<unsigned char, kBase64Size + 1> encoded{};
  const int size = EVP_EncodeBlock(encoded.data(), bytes_.data(), static_cast<int>(bytes_.size()));
  return {reinterpret_cast<const char*>(encoded.data()), static_cast<std::size_t>(size)};
}

std::string VerifyingKey::id() const {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (EVP_Digest(bytes_.data(), bytes_.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL cannot compute SHA-256 on this machine");
  return hexadecimal(std::span(digest).first(kIdBytes));
}

bool VerifyingKey::verify(std::span<const std::uint8_t> message,
                          std::span<const std::uint8_t> signature) const {
  const openssl::Key key(
      EVP_PKEY_new_raw_public_key(EVP_PKEY_ED25519, nullptr, bytes_.data(), bytes_.size()));
  const openssl::DigestContext context(EVP_MD_CTX_new());
  return key && context &&
         EVP_DigestVerifyInit(context.get(), nullptr, nullptr, nullptr, key.get()) == 1 &&
         EVP_DigestVerify(context.get(), signature.data(), signature.size(), message.data(),
                          message.size()) == 1;
}

}  // namespace galilean
