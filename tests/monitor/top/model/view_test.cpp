// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/view.h"

#include <gtest/gtest.h>

#include "tests/monitor/top/model/told.h"

namespace galilean::monitor::top {
namespace {

TEST_F(Told, CertaintyDecaysBetweenMessages) {
  tell_of_io();
  ASSERT_EQ(view_of("io").variables.size(), 1u);
  EXPECT_NEAR(view_of("io").variables[0].certainty, 0.5, 1e-6);
  clock.advance(std::chrono::seconds(2));
  EXPECT_NEAR(view_of("io").variables[0].certainty, 0.3, 1e-6);
  clock.advance(std::chrono::seconds(9));
  EXPECT_EQ(view_of("io").variables[0].certainty, 0);
}

TEST_F(Told, WithoutAMonitorTheRobotsOwnFrameIsShown) {
  tell_of_io();
  EXPECT_EQ(view_of("").map_title, "io's own frame (no monitor)");
  tell_of_map(3);
  View view = view_of("");
  EXPECT_EQ(view.map_title, "the team's map");
  ASSERT_EQ(view.objects.size(), 1u);
  EXPECT_EQ(view.objects[0].position_m.x(), 3);
  clock.advance(std::chrono::seconds(6));
  view = view_of("");
  EXPECT_EQ(view.map_title, "io's own frame (no monitor)");
}

TEST_F(Told, BytesThatAreNoMessageChangeNothing) {
  tell_of_map(3);
  tell("rt/team/objects", msg::ObjectMap::kRosType, Bytes().number<std::uint32_t>(1));
  tell_of_io();
  EXPECT_EQ(view_of("").objects.size(), 1u);
}

}  // namespace
}  // namespace galilean::monitor::top
