// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/once.h"

#include <poll.h>

#include <algorithm>
#include <iostream>

#include "monitor/top/panels/layout.h"

namespace galilean::monitor::top {
namespace {

constexpr int kLookEach_ms = 200;

/// Returns whether there are robots, and each has sent its state, program and variables.
bool all_is_known(const Team& team) {
  for (const auto& [name, robot] : team.robots())
    if (!robot.state || !robot.program || robot.variables.items.empty()) return false;
  return !team.robots().empty();
}

/// The robot that the picture is of: the one that was asked for, or else the first.
std::string shown_robot(const Team& team, const std::string& asked) {
  if (team.find(asked) || team.robots().empty()) return asked;
  return team.robots().begin()->first;
}

void wait_until_known(DashboardFeed& feed, Termination& termination, const Clock& clock,
                      const std::string& robot) {
  constexpr Duration kMost = std::chrono::seconds(3), kMore = std::chrono::milliseconds(500);
  Time known{};
  const Time start = clock.now();
  while (!termination.asked() && clock.now() - start < kMost) {
    pollfd events[] = {{feed.descriptor(), POLLIN, 0}, {termination.descriptor(), POLLIN, 0}};
    ::poll(events, 2, kLookEach_ms);
    feed.poll();
    feed.look_through(shown_robot(feed.model().team(), robot));
    if (known == Time{} && all_is_known(feed.model().team())) known = clock.now();
    if (known != Time{} && clock.now() - known >= kMore) break;
  }
}

/// Returns a picture with room for every robot, state and variable, and for a map.
Canvas picture_of(const View& view) {
  constexpr int kColumns = 110, kAround = 16, kLeast = 36;
  const auto lines = 3 * view.robots.size() + view.machine.states.size() +
                     view.machine.conditions.size() + view.variables.size();
  const int rows = std::max(kLeast, kAround + static_cast<int>(lines) * 4 / 3);
  auto canvas = lay_out(view, {}, kColumns, rows).canvas;
  for (int column = 0; column < kColumns; ++column)  // clears the help on keys
    canvas.set(rows - 1, column, U' ', Style::kPlain);
  return canvas;
}

}  // namespace

int print_once(DashboardFeed& feed, Termination& termination, const Clock& clock,
               const std::string& robot) {
  wait_until_known(feed, termination, clock, robot);
  AlarmFinder finder;
  AlarmBoard board;
  board.update(finder.find(feed.model(), clock.now()), clock.now());
  Curves curves(feed.history());
  const auto view = make_view({feed.model(), clock, feed.model().identities(), &curves, &board},
                              {.robot = robot});
  std::cout << picture_of(view).text();
  return view.robots.empty() ? 1 : 0;
}

}  // namespace galilean::monitor::top
