// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/operator_key.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>

#include "core/signing/trusted_keys.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

/// A user's state folder of this test.
class OperatorKey : public testing::Test {
 protected:
  OperatorKey() {
    if (const char* state = std::getenv("XDG_STATE_HOME")) before = state;
    setenv("XDG_STATE_HOME", folder.path().c_str(), 1);
  }
  ~OperatorKey() override {
    if (before.empty())
      unsetenv("XDG_STATE_HOME");
    else
      setenv("XDG_STATE_HOME", before.c_str(), 1);
  }

  const TemporaryFolder folder;
  std::string before;
};

TEST_F(OperatorKey, WhoHasNoneSignsNothing) {
  const auto signer = find_signer("");
  ASSERT_TRUE(signer) << signer.error().message;
  EXPECT_EQ(signer.value(), nullptr);
}

TEST_F(OperatorKey, TheMonitorsIsThatOfItsUsersCommands) {
  const auto key = open_operator_key(folder / "galilean");
  ASSERT_TRUE(key) << key.error().message;
  const auto signer = find_signer("");
  ASSERT_TRUE(signer) << signer.error().message;
  ASSERT_NE(signer.value(), nullptr);
  EXPECT_EQ(signer.value()->key_id(), key.value().verifying_key().id());
  const auto trusted = TrustedKeys::load(public_key_file(operator_key_file(folder / "galilean")));
  ASSERT_TRUE(trusted) << trusted.error().message;
  EXPECT_NE(trusted.value().find(signer.value()->key_id()), nullptr);
  EXPECT_NE(trusted.value().all()[0].name.find('@'), std::string::npos);
}

TEST_F(OperatorKey, OneThatIsNamedMustBeThere) {
  const auto missing = find_signer((folder / "none.key").string());
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("none.key cannot be read"), std::string::npos);
}

TEST_F(OperatorKey, OneThatOthersCanReadIsNotUsed) {
  const auto file = operator_key_file(folder / "galilean");
  ASSERT_TRUE(open_operator_key(folder / "galilean"));
  ASSERT_EQ(chmod(file.c_str(), 0644), 0);
  EXPECT_FALSE(find_signer(""));
}

}  // namespace
}  // namespace galilean::monitor
