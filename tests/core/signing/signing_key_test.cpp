// SPDX-License-Identifier: BSD-3-Clause
#include "core/signing/signing_key.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "core/signing/trusted_keys.h"
#include "tests/temporary_folder.h"

namespace galilean {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

Bytes from_hex(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

/// RFC 8032, section 7.1: tests 1 to 3.
struct Vector {
  const char* seed;
  const char* public_key;
  const char* message;
  const char* signature;
};
constexpr Vector kVectors[] = {
    {"9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60",
     "d75a980182b10ab7d54bfed3c964073a0ee172f3daa62325af021a68f707511a", "",
     "e5564300c360ac729086e2cc806e828a84877f1eb8e5d974d873e06522490155"
     "5fb8821590a33bacc61e39701cf9b46bd25bf5f0595bbe24655141438e7a100b"},
    {"4ccd089b28ff96da9db6c346ec114e0f5b8a319f35aba624da8cf6ed4fb8a6fb",
     "3d4017c3e843895a92b70aa74d1b7ebc9c982ccf2ec4968cc0cd55f12af4660c", "72",
     "92a009a9f0d4cab8720e820b5f642540a2b27b5416503f8fb3762223ebdb69da"
     "085ac1e43e15996e458f3613d0f11d8c387b2eaeb4302aeeb00d291612bb0c00"},
    {"c5aa8df43f9f837bedb7442f31dcb7b166d38535076f094b85ce3a2e0b4458f7",
     "fc51cd8e6218a1a38da47ed00230f0580816ed13ba3303ac5deb911548908025", "af82",
     "6291d657deec24024827e69c3abe01a30ce548a284743a445e3680d7db5ac3ac"
     "18ff9b538d16f290ae67f760984dc6594a7c15e9716ed28dc027beceea1ec40a"}};

SigningKey key_of(const Vector& vector) {
  SigningKey::Seed seed{};
  const Bytes bytes = from_hex(vector.seed);
  std::copy(bytes.begin(), bytes.end(), seed.begin());
  auto key = SigningKey::from_seed(seed);
  if (!key) throw std::runtime_error(key.error().message);
  return std::move(key).value();
}

SigningKey new_key() {
  auto key = SigningKey::make();
  if (!key) throw std::runtime_error(key.error().message);
  return std::move(key).value();
}

mode_t mode_of(const std::filesystem::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 ? status.st_mode & 0777U : 0U;
}

TEST(SigningKey, SignsAsRfc8032Says) {
  for (const Vector& vector : kVectors) {
    const SigningKey key = key_of(vector);
    const auto& public_bytes = key.verifying_key().bytes();
    EXPECT_EQ(Bytes(public_bytes.begin(), public_bytes.end()), from_hex(vector.public_key));
    const auto signature = key.sign(from_hex(vector.message));
    ASSERT_TRUE(signature);
    EXPECT_EQ(signature.value(), from_hex(vector.signature));
    EXPECT_TRUE(key.verifying_key().verify(from_hex(vector.message), signature.value()));
  }
}

TEST(SigningKey, AChangeOfOneBitIsNoticed) {
  const SigningKey key = key_of(kVectors[2]);
  const Bytes message = from_hex(kVectors[2].message), signature = from_hex(kVectors[2].signature);
  for (std::size_t bit = 0; bit < 8 * signature.size(); ++bit) {
    Bytes changed = signature;
    changed[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(key.verifying_key().verify(message, changed)) << "bit " << bit;
  }
  Bytes other = message;
  other[0] ^= 1U;
  EXPECT_FALSE(key.verifying_key().verify(other, signature));
  EXPECT_FALSE(key.verifying_key().verify(message, {}));
  EXPECT_FALSE(key.verifying_key().verify(message, Bytes(63, 0)));
  EXPECT_FALSE(new_key().verifying_key().verify(message, signature));
}

TEST(SigningKey, IsTheSameOnceItWasSaved) {
  const TemporaryFolder folder;
  const auto file = folder / "operator.key";
  const SigningKey key = new_key();
  ASSERT_TRUE(key.save(file, "anna@lab"));
  EXPECT_EQ(mode_of(file), 0600U);
  const auto again = SigningKey::load(file);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again.value().verifying_key(), key.verifying_key());
  const auto trusted = TrustedKeys::load(public_key_file(file));
  ASSERT_TRUE(trusted) << trusted.error().message;
  ASSERT_EQ(trusted.value().all().size(), 1U);
  EXPECT_EQ(trusted.value().all()[0].name, "anna@lab");
  EXPECT_EQ(trusted.value().all()[0].key, key.verifying_key());
}

TEST(SigningKey, AKeyThatIsThereIsNeverReplaced) {
  const TemporaryFolder folder;
  const auto file = folder / "new" / "operator.key";
  const auto first = load_or_make_key(file, "anna");
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(std::filesystem::status(file.parent_path()).permissions(),
            std::filesystem::perms::owner_all);
  ASSERT_TRUE(new_key().save(file, "ben"));
  const auto second = load_or_make_key(file, "ben");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second.value().verifying_key(), first.value().verifying_key());
}

TEST(SigningKey, AMissingOrForeignPublicHalfIsWrittenAnew) {
  const TemporaryFolder folder;
  const auto file = folder / "operator.key";
  const auto key = load_or_make_key(file, "anna");
  ASSERT_TRUE(key);
  for (const std::string text : {"", "nonsense\n"}) {
    std::filesystem::remove(public_key_file(file));
    if (!text.empty()) std::ofstream(public_key_file(file)) << text;
    ASSERT_TRUE(load_or_make_key(file, "anna"));
    const auto trusted = TrustedKeys::load(public_key_file(file));
    ASSERT_TRUE(trusted) << trusted.error().message;
    EXPECT_EQ(trusted.value().all()[0].key, key.value().verifying_key());
  }
}

TEST(SigningKey, AKeyThatIsTornEmptyOrAFolderIsNeitherUsedNorReplaced) {
  const TemporaryFolder folder;
  const auto whole = folder / "whole.key";
  ASSERT_TRUE(new_key().save(whole, "anna"));
  std::ifstream in(whole);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto file = folder / "operator.key";
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, text.size() / 2}) {
    std::ofstream(file) << text.substr(0, size);
    chmod(file.c_str(), 0600);
    const auto torn = load_or_make_key(file, "anna");
    ASSERT_FALSE(torn) << size;
    EXPECT_THAT(torn.error().message, HasSubstr("where it is removed, 'galilean keys' makes"));
    EXPECT_EQ(std::filesystem::file_size(file), size);
    EXPECT_FALSE(std::filesystem::exists(public_key_file(file)));
    std::filesystem::remove(file);
  }
  std::filesystem::create_directory(file);
  const auto as_folder = load_or_make_key(file, "anna");
  ASSERT_FALSE(as_folder);
  EXPECT_THAT(as_folder.error().message, HasSubstr("it is a folder, and no file"));
}

TEST(SigningKey, SaysWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  const auto missing = SigningKey::load(folder / "none.key");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("cannot be read"));
  const auto file = folder / "operator.key";
  std::ofstream(file) << "-----BEGIN PRIVATE KEY-----\nAAAA\n-----END PRIVATE KEY-----\n";
  chmod(file.c_str(), 0600);
  const auto broken = SigningKey::load(file);
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message, HasSubstr("holds no Ed25519 key"));
  std::filesystem::remove(file);
  ASSERT_TRUE(new_key().save(file, "anna"));
  chmod(file.c_str(), 0640);
  const auto open = SigningKey::load(file);
  ASSERT_FALSE(open);
  EXPECT_THAT(open.error().message, HasSubstr("chmod 600"));
}

}  // namespace
}  // namespace galilean
