// SPDX-License-Identifier: BSD-3-Clause
#include "core/signing/trusted_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/temporary_folder.h"

namespace galilean {
namespace {

using testing::HasSubstr;

/// RFC 8032's first two public keys, in base64.
constexpr const char* kFirst = "11qYAYKxCrfVS/7TyWQHOg7hcvPapiMlrwIaaPcHURo=";
constexpr const char* kSecond = "PUAXw+hDiVqStwqnTRt+vJyYLM8uxJaMwM1V8Sr0Zgw=";

std::string line(const std::string& key, const std::string& name) {
  return "ed25519 " + key + " " + name + "\n";
}

TEST(TrustedKeys, ReadsALineAKeyAndLeavesCommentsOut) {
  const auto keys =
      TrustedKeys::read("# the lab\n\n" + line(kFirst, "anna@lab") + "  " +
                            line(kSecond, "the monitor of room 2\r") + line(kFirst, "anna again"),
                        "team.keys");
  ASSERT_TRUE(keys) << keys.error().message;
  ASSERT_EQ(keys.value().all().size(), 2U);
  EXPECT_EQ(keys.value().all()[0].name, "anna@lab");
  EXPECT_EQ(keys.value().all()[0].key.text(), kFirst);
  EXPECT_EQ(keys.value().all()[1].name, "the monitor of room 2");
  const auto& second = keys.value().all()[1];
  EXPECT_EQ(second.id.size(), 16U);
  ASSERT_NE(keys.value().find(second.id), nullptr);
  EXPECT_EQ(keys.value().find(second.id)->name, second.name);
  EXPECT_EQ(keys.value().find("0123456789abcdef"), nullptr);
  EXPECT_EQ(keys.value().find(""), nullptr);
}

TEST(TrustedKeys, ANameMayBeMissing) {
  const auto keys = TrustedKeys::read(std::string("ed25519 ") + kFirst, "team.keys");
  ASSERT_TRUE(keys) << keys.error().message;
  EXPECT_EQ(keys.value().all()[0].name, "");
}

TEST(TrustedKeys, SaysWhichLineIsWrong) {
  const std::string wrong[] = {
      "ssh-ed25519 AAAA anna",
      "ed25519",
      "ed25519 AAAA anna",
      "ed25519 11qYAYKxCrfVS/7TyWQHOg7hcvPapiMlrwIaaPcHURo anna",    // without padding
      "ed25519 11qYAYKxCrfVS/7TyWQHOg7hcvPapiMlrwIaaPcHUR*= anna",   // no base64
      "ed25519 11qYAYKxCrfVS/7TyWQHOg7hcvPapiMlrwIaaPcHURp= anna"};  // bits that are left over
  for (const auto& each : wrong) {
    const auto keys = TrustedKeys::read(line(kFirst, "anna") + each + "\n", "team.keys");
    ASSERT_FALSE(keys) << each;
    EXPECT_THAT(keys.error().message, HasSubstr("team.keys:2: ")) << each;
  }
}

TEST(TrustedKeys, AFileWithoutAKeyIsAnError) {
  const TemporaryFolder folder;
  const auto file = folder / "team.keys";
  EXPECT_FALSE(TrustedKeys::load(file));
  std::ofstream(file) << "# nobody\n";
  const auto none = TrustedKeys::load(file);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("names no key"));
}

TEST(TrustedKeys, APrivateKeyIsToldFromAPublicOne) {
  const auto wrong = TrustedKeys::read(
      "-----BEGIN PRIVATE KEY-----\nMC4=\n-----END PRIVATE KEY-----\n", "operator.key");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, HasSubstr("operator.key is a private key"));
}

TEST(TrustedKeys, AFileThatEverybodyMayWriteIsNotTrusted) {
  const TemporaryFolder folder;
  const auto file = folder / "team.keys";
  std::ofstream(file) << line(kFirst, "anna");
  ASSERT_EQ(chmod(file.c_str(), 0646), 0);
  const auto open = TrustedKeys::load(file);
  ASSERT_FALSE(open);
  EXPECT_THAT(open.error().message, HasSubstr("could add a key"));
  ASSERT_EQ(chmod(file.c_str(), 0644), 0);
  EXPECT_TRUE(TrustedKeys::load(file));
}

TEST(TrustedKeys, WhatIsNoFileIsAnErrorAndKeepsNobodyWaiting) {
  const TemporaryFolder folder;
  const auto as_folder = TrustedKeys::load(folder.path());
  ASSERT_FALSE(as_folder);
  EXPECT_THAT(as_folder.error().message, HasSubstr("it is a folder, and no file"));
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(TrustedKeys::load(pipe));
  std::ofstream(folder / "empty") << "";
  EXPECT_FALSE(TrustedKeys::load(folder / "empty"));
}

}  // namespace
}  // namespace galilean
