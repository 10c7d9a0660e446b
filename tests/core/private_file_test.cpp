// SPDX-License-Identifier: BSD-3-Clause
#include "core/private_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "tests/temporary_folder.h"

namespace galilean {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

unsigned mode_of(const fs::path& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 0777 : 0;
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Lets every right through, so that a mode is that of the call.
class PrivateFile : public testing::Test {
 protected:
  PrivateFile() : before_(umask(0)) {}
  ~PrivateFile() override { umask(before_); }
  const TemporaryFolder folder;

 private:
  mode_t before_;
};

TEST_F(PrivateFile, IsMadeForItsOwnerAloneWhateverTheUmask) {
  const auto opened = open_private_file(folder / "a.log", O_WRONLY | O_APPEND);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_TRUE(write_all(opened.value(), "a secret\n"));
  close(opened.value());
  EXPECT_EQ(mode_of(folder / "a.log"), 0600U);
  EXPECT_EQ(content_of(folder / "a.log"), "a secret\n");
}

TEST_F(PrivateFile, OneThatOthersCouldReadIsTakenFromThemAndKeepsItsText) {
  std::ofstream(folder / "a.log") << "old ";
  ASSERT_EQ(mode_of(folder / "a.log"), 0666U);
  const auto opened = open_private_file(folder / "a.log", O_WRONLY | O_APPEND);
  ASSERT_TRUE(opened);
  EXPECT_TRUE(write_all(opened.value(), "new"));
  close(opened.value());
  EXPECT_EQ(mode_of(folder / "a.log"), 0600U);
  EXPECT_EQ(content_of(folder / "a.log"), "old new");
}

TEST_F(PrivateFile, ADeviceKeepsItsRights) {
  const auto before = mode_of("/dev/null");
  const auto opened = open_private_file("/dev/null", O_WRONLY);
  ASSERT_TRUE(opened);
  close(opened.value());
  take_from_others("/dev/null");
  EXPECT_EQ(mode_of("/dev/null"), before);
}

TEST_F(PrivateFile, TakingItFromOthersGivesItsOwnerNoRight) {
  std::ofstream(folder / "a") << "text";
  chmod((folder / "a").c_str(), 0444);
  take_from_others(folder / "a");
  EXPECT_EQ(mode_of(folder / "a"), 0400U);
  take_from_others(folder / "none");
  EXPECT_FALSE(fs::exists(folder / "none"));
}

TEST_F(PrivateFile, IsReplacedAsAWhole) {
  std::ofstream(folder / "tokens") << "the old text, which is longer";
  ASSERT_TRUE(replace_private_file(folder / "tokens", "new"));
  EXPECT_EQ(content_of(folder / "tokens"), "new");
  EXPECT_EQ(mode_of(folder / "tokens"), 0600U);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "no draft is left";
}

TEST_F(PrivateFile, WhatCannotBeReplacedSaysWhichFileAndLeavesNoDraft) {
  const auto nowhere = replace_private_file(folder / "none" / "tokens", "new");
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr((folder / "none" / "tokens").string()));
  fs::create_directories(folder / "tokens" / "inside");
  EXPECT_FALSE(replace_private_file(folder / "tokens", "new"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST_F(PrivateFile, ANewOneHasItsModeWhateverTheUmaskAndOneThatIsThereStays) {
  umask(0777);
  ASSERT_TRUE(write_new_file(folder / "key.pub", "the first", 0644));
  ASSERT_TRUE(write_new_file(folder / "key.pub", "the second", 0600));
  EXPECT_EQ(mode_of(folder / "key.pub"), 0644U);
  EXPECT_EQ(content_of(folder / "key.pub"), "the first");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "no draft is left";
}

TEST_F(PrivateFile, ANewOneThatCannotBeWrittenSaysWhichFile) {
  const auto nowhere = write_new_file(folder / "none" / "key", "new", 0600);
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr((folder / "none" / "key").string()));
}

TEST_F(PrivateFile, FoldersThatAreMissingAreMadeForTheOwnerAndOthersStay) {
  ASSERT_EQ(mkdir((folder / "shared").c_str(), 0755), 0);
  const fs::path inner = folder / "shared" / "state" / "galilean";
  ASSERT_TRUE(make_private_folder(inner));
  EXPECT_EQ(mode_of(folder / "shared"), 0755U);
  EXPECT_EQ(mode_of(inner.parent_path()), 0700U);
  EXPECT_EQ(mode_of(inner), 0700U);
  EXPECT_TRUE(make_private_folder(inner));
  EXPECT_TRUE(make_private_folder(inner.string() + "/"));
  std::ofstream(folder / "file") << "text";
  const auto no_folder = make_private_folder(folder / "file");
  ASSERT_FALSE(no_folder);
  EXPECT_THAT(no_folder.error().message, HasSubstr((folder / "file").string()));
}

}  // namespace
}  // namespace galilean
