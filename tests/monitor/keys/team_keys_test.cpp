// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/team_keys.h"

#include <gmock/gmock.h>
#include <openssl/pem.h>
#include <openssl/pkcs7.h>
#include <openssl/sha.h>
#include <sys/stat.h>

#include <array>
#include <ctime>
#include <fstream>
#include <iterator>

#include "core/secure_folder.h"
#include "core/wire/authentication/revoked_list.h"
#include "monitor/keys/authority.h"
#include "monitor/tls/openssl.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::int64_t in_a_day() {
  return static_cast<std::int64_t>(std::time(nullptr)) + 86400;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

openssl::Certificate certificate_in(const fs::path& file) {
  const auto text = text_of(file);
  const openssl::Bio memory(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  return openssl::Certificate(PEM_read_bio_X509(memory.get(), nullptr, nullptr, nullptr));
}

bool is_issued_by(const fs::path& certificate, const fs::path& authority) {
  const auto member = certificate_in(certificate), ca = certificate_in(authority);
  if (!member || !ca) return false;
  const openssl::Key key(X509_get_pubkey(ca.get()));
  return X509_verify(member.get(), key.get()) == 1;
}

/// What an S/MIME document says, if the authority in `ca_file` has signed it; as Cyclone checks it.
std::string signed_text(const fs::path& file, const fs::path& ca_file) {
  const auto text = text_of(file);
  const openssl::Bio memory(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  BIO* content = nullptr;
  PKCS7* document = SMIME_read_PKCS7(memory.get(), &content);
  const auto ca = certificate_in(ca_file);
  X509_STORE* store = X509_STORE_new();
  X509_STORE_add_cert(store, ca.get());
  const openssl::Bio out(BIO_new(BIO_s_mem()));
  std::string said;
  if (document && content &&
      PKCS7_verify(document, nullptr, store, content, out.get(), PKCS7_TEXT) == 1) {
    char* data = nullptr;
    const long size = BIO_get_mem_data(out.get(), &data);
    said.assign(data, static_cast<std::size_t>(size));
  }
  X509_STORE_free(store);
  BIO_free(content);
  PKCS7_free(document);
  return said;
}

mode_t mode_of(const fs::path& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 0777U : 0U;
}

class TeamKeysTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto made = keys.init();
    ASSERT_TRUE(made) << made.error().message;
  }
  MemberFiles add(const std::string& name, MemberRole role = MemberRole::kRobot) const {
    const auto added = keys.add(name, role, in_a_day());
    EXPECT_TRUE(added) << added.error().message;
    return MemberFiles(keys.member_folder(name));
  }

  const TemporaryFolder folder;
  const TeamKeys keys{folder / "team"};
  const MemberFiles team{folder / "team"};
};

TEST_F(TeamKeysTest, AMembersFolderIsWholeAndForItsOwnerAlone) {
  const auto io = add("io");
  for (const auto& file : {io.identity_ca, io.permissions_ca, io.certificate, io.key, io.governance,
                           io.grant, io.revoked})
    EXPECT_EQ(mode_of(file), 0600U) << file;
  EXPECT_EQ(mode_of(keys.member_folder("io")), 0700U);
  EXPECT_EQ(mode_of(folder / "team"), 0700U);
  EXPECT_FALSE(fs::exists(keys.member_folder("io") / "identity_ca.key"));
  EXPECT_FALSE(fs::exists(keys.member_folder("io") / "permissions_ca.key"));
}

TEST_F(TeamKeysTest, OneAuthorityVouchesForMembersAndTheOtherForGrants) {
  const auto io = add("io");
  EXPECT_TRUE(is_issued_by(io.certificate, team.identity_ca));
  EXPECT_FALSE(is_issued_by(io.certificate, team.permissions_ca));
  EXPECT_THAT(signed_text(io.grant, team.permissions_ca), HasSubstr("rt/io/*"));
  EXPECT_EQ(signed_text(io.grant, team.identity_ca), "");
  EXPECT_THAT(signed_text(io.governance, team.permissions_ca), HasSubstr("domain_rule"));
}

TEST_F(TeamKeysTest, AGrantThatWasChangedIsNotSignedAnyMore) {
  const auto io = add("io");
  auto text = text_of(io.grant);
  const auto at = text.find("rt/io/");
  ASSERT_NE(at, text.npos);
  text.replace(at, 6, "rt/xx/");
  std::ofstream(io.grant) << text;
  EXPECT_EQ(signed_text(io.grant, team.permissions_ca), "");
}

TEST_F(TeamKeysTest, AMemberCannotSignAGrantForItself) {
  const auto eve = add("eve", MemberRole::kViewer);
  const auto as_authority = Authority::read(eve.certificate, eve.key);
  ASSERT_TRUE(as_authority) << as_authority.error().message;
  const auto grant = as_authority.value().sign("<dds/>\n");
  ASSERT_TRUE(grant);
  std::ofstream(eve.grant) << grant.value();
  EXPECT_EQ(signed_text(eve.grant, team.permissions_ca), "");
}

TEST_F(TeamKeysTest, ASerialNumberTellsTheBeginningOfTheMembersGuid) {
  const auto io = add("io");
  const auto certificate = certificate_in(io.certificate);
  ASSERT_TRUE(certificate);
  unsigned char* encoded = nullptr;
  const int size = i2d_X509_NAME(X509_get_subject_name(certificate.get()), &encoded);
  ASSERT_GT(size, 0);
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest{};
  SHA256(encoded, static_cast<std::size_t>(size), digest.data());
  OPENSSL_free(encoded);
  const auto prefix = wire::subject_prefix(digest);
  EXPECT_EQ(wire::prefix_of_serial(X509_get0_serialNumber(certificate.get())), prefix);
  EXPECT_NE(prefix[0] & 0x80, 0);
  const auto pem = text_of(io.certificate);
  EXPECT_EQ(
      wire::prefix_of_certificate({reinterpret_cast<const std::uint8_t*>(pem.data()), pem.size()}),
      prefix);
  EXPECT_EQ(wire::prefix_of_certificate({}), std::nullopt);
}

TEST_F(TeamKeysTest, WhoIsRevokedStandsInEveryMembersList) {
  const auto io = add("io"), eve = add("eve");
  const auto certificate = certificate_in(eve.certificate);
  ASSERT_TRUE(certificate);
  const auto prefix = wire::prefix_of_serial(X509_get0_serialNumber(certificate.get()));
  ASSERT_TRUE(prefix);
  const auto before = wire::read_revoked(io.revoked.string(), io.identity_ca.string());
  ASSERT_TRUE(before);
  EXPECT_TRUE(before->empty());

  ASSERT_TRUE(keys.revoke("eve"));
  for (const auto& files : {io, eve, team, add("late")}) {
    const auto revoked = wire::read_revoked(files.revoked.string(), team.identity_ca.string());
    ASSERT_TRUE(revoked) << files.revoked;
    EXPECT_EQ(*revoked, wire::RevokedMembers{*prefix});
  }
  EXPECT_FALSE(wire::read_revoked(io.revoked.string(), team.permissions_ca.string()))
      << "a list of another authority";
  EXPECT_FALSE(wire::read_revoked(io.key.string(), team.identity_ca.string()));
}

TEST_F(TeamKeysTest, ARevokedNameCanBeGivenAgainAndTheOldKeysStayOut) {
  const auto first = text_of(add("eve").certificate);
  ASSERT_TRUE(keys.revoke("eve"));
  const auto again = keys.revoke("eve");
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message, HasSubstr("there is no member 'eve'"));
  EXPECT_NE(text_of(add("eve").certificate), first);
  const auto members = keys.list();
  ASSERT_TRUE(members);
  ASSERT_EQ(members.value().size(), 2U);
  EXPECT_TRUE(members.value()[0].revoked);
  EXPECT_FALSE(members.value()[1].revoked);
  EXPECT_NE(members.value()[0].serial, members.value()[1].serial);
}

TEST_F(TeamKeysTest, RenewingKeepsTheRoleAndRevokingTakesOldAndNewKeys) {
  add("anna", MemberRole::kViewer);
  const auto renewed = keys.renew("anna", in_a_day());
  ASSERT_TRUE(renewed) << renewed.error().message;
  ASSERT_TRUE(keys.revoke("anna"));
  const auto members = keys.list();
  ASSERT_TRUE(members);
  ASSERT_EQ(members.value().size(), 2U);
  for (const auto& member : members.value()) {
    EXPECT_EQ(member.role, MemberRole::kViewer);
    EXPECT_TRUE(member.revoked);
  }
}

TEST_F(TeamKeysTest, WhatCannotBeDoneIsRefusedAndChangesNothing) {
  add("io");
  const auto list = text_of(folder / "team/members.json");
  EXPECT_FALSE(keys.init());
  for (const char* name : {"", "io", "../io", "a/b", "a,b", "a=b", "a|b", "a b", "<a>", "team"}) {
    const auto added = keys.add(name, MemberRole::kRobot, in_a_day());
    EXPECT_FALSE(added) << name;
  }
  EXPECT_FALSE(keys.add(std::string(65, 'a'), MemberRole::kViewer, in_a_day()));
  const auto renewed = keys.renew("oi", in_a_day());
  ASSERT_FALSE(renewed);
  EXPECT_THAT(renewed.error().message, HasSubstr("there is no member 'oi'"));
  EXPECT_EQ(text_of(folder / "team/members.json"), list);
}

TEST_F(TeamKeysTest, ADamagedListIsNamedAndKept) {
  for (const char* text : {"", "{", "[]", R"({"certificates": [{"name": 7}]})",
                           R"({"certificates": [{"name": "io", "role": "king", "serial": "",
                              "expires_s": 1, "revoked": false}]})"}) {
    std::ofstream(folder / "team/members.json") << text;
    const auto added = keys.add("io", MemberRole::kRobot, in_a_day());
    ASSERT_FALSE(added) << text;
    EXPECT_THAT(added.error().message, HasSubstr("members.json is damaged"));
    EXPECT_EQ(text_of(folder / "team/members.json"), text);
  }
}

TEST(TeamKeys, AFolderWithoutATeamIsSaidToBeNone) {
  const TemporaryFolder folder;
  for (const auto& place : {folder.path(), folder / "none"}) {
    const auto added = TeamKeys(place).add("io", MemberRole::kRobot, in_a_day());
    ASSERT_FALSE(added);
    EXPECT_THAT(added.error().message, HasSubstr("galilean team keys init"));
  }
}

}  // namespace
}  // namespace galilean::monitor
