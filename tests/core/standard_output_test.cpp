// SPDX-License-Identifier: BSD-3-Clause
#include "core/standard_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace galilean {
namespace {

/// As a program that prints to `path`, or to a standard output that is closed, and ends with
/// `code`.
[[noreturn]] void print_to(const char* path, int code) {
  if (*path != '\0')
    dup2(open(path, O_WRONLY), STDOUT_FILENO);
  else
    close(STDOUT_FILENO);
  tell_unwritten_output();
  if (*path == '\0' && open("/dev/null", O_WRONLY) == STDOUT_FILENO) _exit(77);
  std::cout << "text\n";
  std::exit(code);
}

constexpr const char* kFull = "/dev/full";
constexpr const char* kSentence = "standard output cannot be written: .*; what was printed is not";

TEST(StandardOutput, ThatCannotBeWrittenIsToldInASentence) {
  // In a process of its own: other tests of this program may have called it already.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(print_to(kFull, 0), testing::ExitedWithCode(1), kSentence);
  EXPECT_EXIT(print_to(kFull, 2), testing::ExitedWithCode(2), kSentence);
  EXPECT_EXIT(print_to("", 0), testing::ExitedWithCode(1), kSentence);
  EXPECT_EXIT(print_to("/dev/null", 0), testing::ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace galilean
