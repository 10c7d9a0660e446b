// SPDX-License-Identifier: BSD-3-Clause
#include "core/file_lock.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include <optional>

#include "tests/temporary_folder.h"

namespace galilean {
namespace {

/// Returns whether somebody who opens the file anew could lock it at once.
bool is_free(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDWR | O_CLOEXEC);
  const bool is_locked = descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  if (descriptor >= 0) close(descriptor);
  return !is_locked;
}

TEST(FileLock, IsHeldUntilItsLastOwnerEnds) {
  const TemporaryFolder folder;
  const auto file = folder / "edit.lock";
  {
    auto taken = FileLock::wait_for(file);
    ASSERT_TRUE(taken) << taken.error().message;
    EXPECT_FALSE(is_free(file));
    std::optional<FileLock> moved(std::move(taken).value());
    EXPECT_FALSE(is_free(file));
    moved.reset();
    EXPECT_TRUE(is_free(file));
  }
  EXPECT_TRUE(FileLock::wait_for(file)) << "nobody has it any more";
}

TEST(FileLock, AFileThatCannotBeMadeIsNamed) {
  const TemporaryFolder folder;
  const auto nowhere = FileLock::wait_for(folder / "none" / "edit.lock");
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, testing::HasSubstr("edit.lock cannot be written"));
}

}  // namespace
}  // namespace galilean
