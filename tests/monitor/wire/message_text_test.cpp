// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/message_text.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

const MessageTree kMessage{{"stamp", {{"sec", 3}}},
                           {"robot", "i\x1b[1mo"},
                           {"problems", MessageTree::array()},
                           {"variables", {{{"name", "a"}, {"bits", {1, 2}}}, {{"name", "b"}}}}};

TEST(MessageText, IsLikeYamlAndShowsNoControlCharacters) {
  EXPECT_EQ(readable_text(kMessage),
            "stamp:\n  sec: 3\nrobot: \"iU+001B[1mo\"\nproblems: []\nvariables:\n"
            "  - name: \"a\"\n    bits: [1, 2]\n  - name: \"b\"\n");
}

TEST(MessageText, ShowsListsOfLists) {
  const auto tree = [](const char* json) { return MessageTree::parse(json); };
  EXPECT_EQ(readable_text(tree(R"({"grid": [[1, 2], [3, 4]], "flags": [[], ["A"]]})")),
            "grid:\n  - [1, 2]\n  - [3, 4]\nflags:\n  - []\n  - [\"A\"]\n");
  EXPECT_EQ(readable_text(tree("[[[1], [2]], [[3]]]")), "- - [1]\n  - [2]\n- - [3]\n");
}

TEST(MessageText, CutsLongLists) {
  EXPECT_TRUE(readable_text(MessageTree(std::vector<int>(40, 1))).ends_with("1, … 8 more]\n"));
}

TEST(MessageText, FindsFieldsByTheirPaths) {
  EXPECT_EQ(*find_field(kMessage, "stamp.sec").value(), 3);
  EXPECT_EQ(*find_field(kMessage, "variables[0].bits[1]").value(), 2);
  EXPECT_EQ(find_field(kMessage, "variables[2].name").value(), nullptr);
  EXPECT_EQ(*find_field(kMessage, "").value(), kMessage);
  EXPECT_FALSE(find_field(kMessage, "stamp.nanosec").ok());
  EXPECT_FALSE(find_field(kMessage, "variables[x]").ok());
  EXPECT_FALSE(find_field(kMessage, "variables[").ok());
}

}  // namespace
}  // namespace galilean::monitor
