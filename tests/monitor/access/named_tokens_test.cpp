// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/named_tokens.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <array>
#include <ctime>
#include <fstream>
#include <iterator>
#include <thread>

#include "monitor/access/digest.h"
#include "monitor/access/token_watch.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::int64_t kNow_s = 1'800'000'000;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

NamedToken token_named(const std::string& name, Right right = Right::kRead) {
  return {.name = name, .right = right, .sha256 = {}, .made_s = kNow_s, .expires_s = {}};
}

class NamedTokens : public testing::Test {
 protected:
  std::string add(const NamedToken& token) const {
    const auto added = add_named_token(folder.path(), token);
    EXPECT_TRUE(added) << added.error().message;
    return added ? added.value() : std::string();
  }
  std::string objection_to(const NamedToken& token) const {
    const auto added = add_named_token(folder.path(), token);
    return added ? std::string() : added.error().message;
  }
  std::vector<NamedToken> read() const {
    const auto tokens = read_named_tokens(file);
    EXPECT_TRUE(tokens) << tokens.error().message;
    return tokens ? tokens.value() : std::vector<NamedToken>();
  }
  /// Writes a file as a hand or a fault might, and returns what is said of it.
  std::string objection_to_text(const std::string& text) const {
    std::ofstream(file) << text;
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    const auto tokens = read_named_tokens(file);
    return tokens ? std::string() : tokens.error().message;
  }

  const TemporaryFolder folder;
  const fs::path file = named_tokens_file(folder.path());
};

TEST_F(NamedTokens, AreStoredAsDigestsForTheOwnersEyesAlone) {
  auto evening = token_named("bert", Right::kOperate);
  evening.expires_s = kNow_s + 8 * 3600;
  const auto anna = add(token_named("anna")), bert = add(evening);
  EXPECT_EQ(anna.size(), 64U) << "256 bits";
  EXPECT_NE(anna, bert);
  EXPECT_EQ(text_of(file).find(anna), std::string::npos);
  struct stat status {};
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600U);

  const auto tokens = read();
  ASSERT_EQ(tokens.size(), 2U);
  EXPECT_EQ(tokens[0].name, "anna");
  EXPECT_EQ(tokens[0].right, Right::kRead);
  EXPECT_EQ(tokens[0].sha256, digest_of(anna));
  EXPECT_EQ(tokens[0].made_s, kNow_s);
  EXPECT_FALSE(tokens[0].expires_s);
  EXPECT_EQ(tokens[1].right, Right::kOperate);
  EXPECT_EQ(tokens[1].expires_s, kNow_s + 8 * 3600);
}

TEST_F(NamedTokens, AFolderWithoutAnyHasNone) {
  EXPECT_TRUE(read().empty());
}

TEST_F(NamedTokens, ANameIsInUseUntilItsTokenIsRevokedOrExpires) {
  auto short_lived = token_named("anna");
  short_lived.expires_s = kNow_s + 10;
  const auto first = add(short_lived);
  EXPECT_THAT(objection_to(token_named("anna")), HasSubstr("tokens revoke anna"));
  auto later = token_named("anna");
  later.made_s = kNow_s + 10;
  const auto second = add(later);
  ASSERT_EQ(read().size(), 1U);
  EXPECT_EQ(read()[0].sha256, digest_of(second));
  ASSERT_TRUE(revoke_named_token(folder.path(), "anna"));
  EXPECT_TRUE(read().empty());
  EXPECT_FALSE(add(token_named("anna")).empty());
}

TEST_F(NamedTokens, NamesThatMisleadAreRefused) {
  for (const auto* name : {"", "a b", "a/b", "\x1b[2J", "anna\n", "операт"})
    EXPECT_THAT(objection_to(token_named(name)), HasSubstr("is not a valid name")) << name;
  EXPECT_THAT(objection_to(token_named(std::string(65, 'a'))), HasSubstr("is not a valid name"));
  EXPECT_THAT(objection_to(token_named("operator")), HasSubstr("operator.token"));
  EXPECT_TRUE(read().empty());
}

TEST_F(NamedTokens, RevokingAnUnknownOneSaysWhichWasMeantAndLeavesTheOthers) {
  (void)add(token_named("anna"));
  const auto misspelt = revoke_named_token(folder.path(), "anan");
  ASSERT_FALSE(misspelt);
  EXPECT_THAT(misspelt.error().message, HasSubstr("did you mean 'anna'?"));
  EXPECT_EQ(read().size(), 1U);
}

TEST_F(NamedTokens, ADamagedFileIsAnErrorAndIsNotOverwritten) {
  const std::string digest(64, 'a');
  const auto with = [](const std::string& item) { return "{\"tokens\": [" + item + "]}"; };
  for (const auto& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("{\"tokens\": 3}"),
        with("3"), with("{}"),
        with(R"({"name": "a", "role": "admin", "made_s": 1, "sha256": ")" + digest + "\"}"),
        with(R"({"name": "a", "role": "viewer", "made_s": 1, "sha256": "a"})"),
        with(R"({"name": "a", "role": "viewer", "made_s": "1", "sha256": ")" + digest + "\"}"),
        with(R"({"name": "a", "role": "viewer", "made_s": 1.5, "sha256": ")" + digest + "\"}"),
        with(R"({"name": "a", "role": "viewer", "made_s": 1, "expires_s": true, "sha256": ")" +
             digest + "\"}"),
        with(R"({"name": "a", "role": "viewer", "made_s": 1, "expires_s": 18446744073709551615, )"
             R"("sha256": ")" +
             digest + "\"}")}) {
    EXPECT_THAT(objection_to_text(text), HasSubstr("tokens.json is damaged")) << text;
    EXPECT_FALSE(add_named_token(folder.path(), token_named("bert"))) << text;
    EXPECT_EQ(text_of(file), text);
  }
}

TEST_F(NamedTokens, AFileThatOthersMayWriteGivesNobodyARight) {
  (void)add(token_named("anna"));
  fs::permissions(file, fs::perms::group_write, fs::perm_options::add);
  const auto tokens = read_named_tokens(file);
  ASSERT_FALSE(tokens);
  EXPECT_THAT(tokens.error().message, HasSubstr("may be written by others"));
}

TEST_F(NamedTokens, EditsAtTheSameTimeLoseNothing) {
  constexpr int kEach = 20;
  const auto add_many = [&](const std::string& prefix) {
    for (int i = 0; i < kEach; ++i) (void)add(token_named(prefix + std::to_string(i)));
  };
  std::thread other([&] { add_many("a"); });
  add_many("b");
  other.join();
  EXPECT_EQ(read().size(), 2U * kEach);
}

TEST_F(NamedTokens, AWatchTellsEachChangeOnce) {
  TokenWatch watch(file);
  const auto at_first = watch.look();
  ASSERT_TRUE(at_first && *at_first);
  EXPECT_TRUE(at_first->value().empty());
  EXPECT_FALSE(watch.look());
  (void)add(token_named("anna"));
  const auto added = watch.look();
  ASSERT_TRUE(added && *added);
  EXPECT_EQ(added->value().size(), 1U);
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(revoke_named_token(folder.path(), "anna"));
  const auto revoked = watch.look();
  ASSERT_TRUE(revoked && *revoked);
  EXPECT_TRUE(revoked->value().empty());
  fs::permissions(file, fs::perms::others_write, fs::perm_options::add);
  const auto opened = watch.look();
  ASSERT_TRUE(opened);
  EXPECT_FALSE(*opened);
  fs::remove(file);
  const auto removed = watch.look();
  ASSERT_TRUE(removed && *removed);
  EXPECT_TRUE(removed->value().empty());
}

TEST_F(NamedTokens, AFileThatIsDatedFarAheadIsWatchedToo) {
  (void)add(token_named("anna"));
  TokenWatch watch(file);
  EXPECT_TRUE(watch.look());
  constexpr std::time_t kYear2286_s = 10'000'000'000;  // in nanoseconds it has no 64-bit number
  const std::array<timespec, 2> times{timespec{kYear2286_s, 0}, timespec{kYear2286_s, 0}};
  ASSERT_EQ(utimensat(AT_FDCWD, file.c_str(), times.data(), 0), 0);
  const auto dated = watch.look();
  ASSERT_TRUE(dated && *dated);
  EXPECT_EQ(dated->value().size(), 1U);
  EXPECT_FALSE(watch.look());
}

}  // namespace
}  // namespace galilean::monitor
