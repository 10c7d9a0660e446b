// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/palette.h"

#include <gtest/gtest.h>

#include <map>

namespace galilean::monitor::top {
namespace {

Environment with(std::map<std::string, std::string> variables) {
  return [variables = std::move(variables)](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? std::string() : found->second;
  };
}

TEST(Palette, TheEnvironmentTellsHowManyColoursThereAre) {
  EXPECT_EQ(colours_of(with({{"TERM", "xterm-256color"}, {"COLORTERM", "truecolor"}})),
            Colours::kTrue);
  EXPECT_EQ(colours_of(with({{"TERM", "xterm-direct"}})), Colours::kTrue);
  EXPECT_EQ(colours_of(with({{"TERM", "tmux-256color"}})), Colours::k256);
  EXPECT_EQ(colours_of(with({{"TERM", "linux"}})), Colours::k16);
  EXPECT_EQ(colours_of(with({{"TERM", "vt220"}})), Colours::kNone);
  EXPECT_EQ(colours_of(with({{"TERM", "xterm-256color"}, {"NO_COLOR", "1"}})), Colours::kNone);
  EXPECT_EQ(colours_of(with({{"TERM", "xterm-256color"}, {"NO_COLOR", ""}})), Colours::k256);
}

TEST(Palette, TheFirstVariableOfTheLocaleThatIsSetCounts) {
  EXPECT_TRUE(is_utf8(with({{"LANG", "en_GB.UTF-8"}})));
  EXPECT_TRUE(is_utf8(with({{"LC_CTYPE", "C.utf8"}, {"LANG", "C"}})));
  EXPECT_FALSE(is_utf8(with({{"LC_ALL", "C"}, {"LANG", "en_GB.UTF-8"}})));
  EXPECT_FALSE(is_utf8(with({})));
}

TEST(Palette, ARobotHasThePagesColourAsFarAsTheTerminalHasIt) {
  EXPECT_EQ(escape_sequence(robot_style(0), Colours::kTrue),
            "\x1b[0;1;38;2;17;17;17;48;2;86;180;233m");
  EXPECT_EQ(escape_sequence(robot_style(1), Colours::k256), "\x1b[0;1;38;5;16;48;5;214m");
  EXPECT_EQ(escape_sequence(robot_style(4), Colours::k16), "\x1b[0;1;97;44m");
  EXPECT_EQ(escape_sequence(robot_style(2), Colours::kNone), "\x1b[0;1;7m");
  EXPECT_EQ(robot_style(7), robot_style(1));
}

TEST(Palette, WithoutColoursNoStyleSetsOne) {
  for (int style = 0; style < static_cast<int>(Style::kRobot) + kRobotStyles; ++style) {
    const std::string sequence = escape_sequence(static_cast<Style>(style), Colours::kNone);
    EXPECT_EQ(sequence.find('3'), std::string::npos) << sequence;
    EXPECT_EQ(sequence.find('9'), std::string::npos) << sequence;
  }
}

}  // namespace
}  // namespace galilean::monitor::top
