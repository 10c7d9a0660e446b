// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <fstream>

#include "core/broken_pipe.h"
#include "monitor/mcap/byte_sink.h"
#include "monitor/mcap/mcap_records.h"
#include "tests/temporary_folder.h"

namespace galilean::mcap {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FileSinkTest : public testing::Test {
 protected:
  [[nodiscard]] FileSink made() const { return FileSink::create(path, true).value(); }
  [[nodiscard]] static std::string complaint(const Result<void>& done) {
    return done ? "" : done.error().message;
  }

  const TemporaryFolder folder;
  const std::string path = folder / "recording.mcap";
  const Bytes bytes = Bytes(100);
};

TEST_F(FileSinkTest, NoOtherWritesAFileThatIsBeingWritten) {
  {
    auto first = made();
    ASSERT_TRUE(first.write(bytes));
    const auto second = FileSink::create(path, true);
    ASSERT_FALSE(second.ok());
    EXPECT_THAT(second.error().message, HasSubstr("is being written by another program"));
    EXPECT_EQ(fs::file_size(path), bytes.size()) << "what the first has written is gone";
    EXPECT_TRUE(first.check_whole());
  }
  EXPECT_TRUE(FileSink::create(path, true).ok());
  EXPECT_EQ(fs::file_size(path), 0U);
}

TEST_F(FileSinkTest, TellsThatItsFileWasDeletedOrReplaced) {
  auto sink = made();
  ASSERT_TRUE(sink.write(bytes));
  EXPECT_TRUE(sink.check_whole());
  fs::remove(path);
  EXPECT_THAT(complaint(sink.check_whole()), HasSubstr("was deleted or replaced"));
  EXPECT_THAT(complaint(sink.sync()), HasSubstr("was deleted or replaced"));
}

TEST_F(FileSinkTest, TellsThatItsFileWasEmptiedAlsoIfItWasLongAgo) {
  auto sink = made();
  ASSERT_TRUE(sink.write(bytes));
  fs::resize_file(path, 0);
  ASSERT_TRUE(sink.write(bytes));
  EXPECT_EQ(fs::file_size(path), 2 * bytes.size()) << "the length tells nothing";
  EXPECT_THAT(complaint(sink.check_whole()), HasSubstr("was emptied or shortened"));
}

TEST_F(FileSinkTest, AFileUnderAnotherNameHasMovedAndIsWhole) {
  auto sink = made();
  EXPECT_FALSE(sink.has_moved());
  fs::rename(path, folder / "other.mcap");
  EXPECT_TRUE(sink.has_moved());
  EXPECT_TRUE(sink.check_whole());
  std::ofstream(path) << "somebody else's";
  EXPECT_TRUE(sink.has_moved());
}

TEST_F(FileSinkTest, GoesBackAndWritesOverWhatIsThere) {
  auto sink = made();
  ASSERT_TRUE(sink.write(bytes));
  ASSERT_TRUE(sink.go_back(50, 2 * bytes.size()));
  EXPECT_EQ(fs::file_size(path), bytes.size()) << "room that is set aside is not the file's";
  ASSERT_TRUE(sink.write(bytes));
  EXPECT_EQ(fs::file_size(path), 150U);
  EXPECT_TRUE(sink.check_whole());
}

TEST_F(FileSinkTest, AFileToWhichNothingCouldBeWrittenDoesNotStay) {
  ignore_file_size_limit();
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit nothing{0, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &nothing), 0);
  const bool written = made().write(bytes).ok();
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_FALSE(written);
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(FileSinkTest, AFileThatWasThereStaysThoughNothingCouldBeWritten) {
  std::ofstream(path) << "mine";
  EXPECT_FALSE(FileSink::create(path, false).ok());
  EXPECT_EQ(fs::file_size(path), 4U);
}

TEST_F(FileSinkTest, ADeviceIsNeitherLockedNorWatchedNorGoneBackIn) {
  auto one = FileSink::create("/dev/null", false);
  auto other = FileSink::create("/dev/null", false);
  ASSERT_TRUE(one.ok() && other.ok());
  EXPECT_TRUE(other.value().write(bytes));
  EXPECT_TRUE(other.value().check_whole());
  EXPECT_FALSE(other.value().has_moved());
  EXPECT_FALSE(other.value().go_back(0, 1));
}

}  // namespace
}  // namespace galilean::mcap
