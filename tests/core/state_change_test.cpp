// SPDX-License-Identifier: BSD-3-Clause
#include "core/state_change.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace galilean {
namespace {

TEST(StateChange, IsCalledByTheStatesThatAreNamed) {
  EXPECT_EQ(change_words("wander", "grab"), "wander -> grab");
  EXPECT_EQ(place_words("wander", "grab"), "at wander -> grab");
  EXPECT_EQ(place_words("", "grab"), "on entering grab");
}

// GALILEAN_WRITE_FIXTURES=1 writes the file instead. The page's test reads the same file.
TEST(StateChange, IsCalledAsOnThePage) {
  const std::pair<const char*, const char*> changes[] = {
      {"wander", "grab"}, {"", "grab"}, {"wander", ""}, {"", ""}};
  std::string text;
  for (const auto& [from, to] : changes)
    text += std::string(from) + "|" + to + "|" + change_words(from, to) + "|" +
            place_words(from, to) + "\n";
  const std::string path = GALILEAN_SOURCE_DIR "/web/tests/fixture/state_changes.txt";
  if (std::getenv("GALILEAN_WRITE_FIXTURES") != nullptr) std::ofstream(path) << text;
  std::ostringstream told;
  told << std::ifstream(path).rdbuf();
  EXPECT_EQ(told.str(), text);
}

}  // namespace
}  // namespace galilean
