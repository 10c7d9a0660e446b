// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/replace_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/temporary_folder.h"

namespace galilean::bhdl {
namespace {

namespace fs = std::filesystem;

class ReplaceFile : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(folder_ / "a.bhdl") << "old"; }

  [[nodiscard]] std::string contents(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name).rdbuf();
    return text.str();
  }
  [[nodiscard]] auto files() const {
    return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
  }

  TemporaryFolder folder_;
};

TEST_F(ReplaceFile, KeepsTheModeAndLeavesNothingBeside) {
  fs::permissions(folder_ / "a.bhdl", fs::perms(0640));
  EXPECT_TRUE(replace_file(folder_ / "a.bhdl", "new"));
  EXPECT_EQ(contents("a.bhdl"), "new");
  EXPECT_EQ(fs::status(folder_ / "a.bhdl").permissions(), fs::perms(0640));
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplaceFile, WritesThroughALink) {
  fs::create_symlink("a.bhdl", folder_ / "link.bhdl");
  EXPECT_TRUE(replace_file(folder_ / "link.bhdl", "new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.bhdl"));
  EXPECT_EQ(contents("a.bhdl"), "new");
}

TEST_F(ReplaceFile, SaysWhyItCannot) {
  const auto replaced = replace_file(folder_ / "none.bhdl", "new");
  ASSERT_FALSE(replaced);
  EXPECT_NE(replaced.error().message.find("none.bhdl"), std::string::npos);
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace galilean::bhdl
