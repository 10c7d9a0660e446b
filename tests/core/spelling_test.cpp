// SPDX-License-Identifier: BSD-3-Clause
#include "core/spelling.h"

#include <gtest/gtest.h>

#include <vector>

namespace galilean {
namespace {

TEST(EditDistance, CountsLettersAddedLeftOutChangedAndSwapped) {
  EXPECT_EQ(edit_distance("trash", "trash", 3), 0);
  EXPECT_EQ(edit_distance("trash", "Trash", 3), 0);
  EXPECT_EQ(edit_distance("trash", "trsh", 3), 1);
  EXPECT_EQ(edit_distance("trash", "trassh", 3), 1);
  EXPECT_EQ(edit_distance("trash", "trath", 3), 1);
  EXPECT_EQ(edit_distance("trash", "tarsh", 3), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting", 5), 3);
}

TEST(EditDistance, StopsAtTheLimit) {
  EXPECT_EQ(edit_distance("abc", "xyz", 2), 3);
  EXPECT_EQ(edit_distance("a", "abcdefgh", 3), 4);
  EXPECT_EQ(edit_distance(std::string(1000, 'a'), std::string(1000, 'a'), 3), 4);
}

TEST(Nearest, IsTheFirstOfTheNearestOrNothing) {
  const std::vector<std::string_view> names{"obstacle0", "obstacle1", "trash"};
  EXPECT_EQ(nearest("obstacl1", names), "obstacle1");
  EXPECT_EQ(nearest("obstacle", names), "obstacle0");
  EXPECT_EQ(nearest("basket", names), "");
  EXPECT_EQ(nearest("", names), "");
}

TEST(MeantName, OfThoseAsNearIsTheOneOfNearestLength) {
  const std::vector<std::string_view> names{"top", "start", "stop"};
  EXPECT_EQ(meant_name("tsop", names), "stop");
  EXPECT_EQ(meant_name("stpo", names), "stop");
  EXPECT_EQ(meant_name("tp", names), "top");
}

TEST(MeantName, IsTheOnlyOneThatTheWordBegins) {
  const std::vector<std::string_view> names{"monitor", "programs", "progress"};
  EXPECT_EQ(meant_name("mon", names), "monitor");
  EXPECT_EQ(meant_name("prog", names), "");
  EXPECT_EQ(meant_name("mo", names), "");
}

TEST(Nearest, IsNothingForAWordThatIsAllWrong) {
  EXPECT_EQ(nearest("p", std::vector<std::string_view>{"h"}), "");
  EXPECT_EQ(nearest("ab", std::vector<std::string_view>{"xy"}), "");
}

}  // namespace
}  // namespace galilean
