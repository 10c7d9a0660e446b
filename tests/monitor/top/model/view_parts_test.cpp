// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/view_parts.h"

#include <gtest/gtest.h>

namespace galilean::monitor::top {
namespace {

TEST(ShowChanges, AConditionIsPlacedByTheNameOfItsFileWithoutTheFolders) {
  Robot robot;
  msg::Transition transition;
  transition.number = 1;
  transition.file = "/opt/share/galilean/programs/office.bhdl";
  transition.line = 31;
  robot.transitions.push_back(transition);
  View view;
  show_changes(robot, 0, view);
  ASSERT_EQ(view.changes.size(), 1U);
  EXPECT_EQ(view.changes.front().place, "office.bhdl:31");
}

}  // namespace
}  // namespace galilean::monitor::top
