// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/help.h"

#include <array>

namespace galilean::monitor::top {

Sheet help_sheet() {
  static constexpr std::array kLines{
      "↑ ↓ j k 1-9  choose a robot; those in trouble come first. A click chooses, too.",
      "Tab          all panels, the states, the variables, the reasons, the map alone",
      "PgUp PgDn    scroll the panel; the mouse's wheel scrolls what it points at",
      "/            show only what has a word in it: robots, or variables on their tab",
      "← →          a second back or on in time; Home: the earliest; l or End: now",
      "a, A         the first alarm was seen; all that are shown were seen",
      "",
      ".            STOP ALL, at once; the line on top says who has not confirmed it",
      "Ctrl-X       STOP ALL, also in a text, where . stops only as the first key",
      "h, H         hold: the robot chosen, or all, stand still until resumed",
      "r, R         resume the robot chosen, or all; asks first",
      "s, S         start: push a bumper, which is what the start state waits for",
      "d            take the robot out of service, or put it back; asks first",
      "J K          choose a state of the robot's program, as a click does; Esc: none",
      "b            break point: stop the robot on entering that state; again: do not",
      "B            its break points: remove, stop, stop team or lock, let through",
      "n, N         step: go on until the next change of state, and stop there",
      "p, P         push a program: check, differences, canary; asks first",
      "u, U         restore the last good program; asks first",
      "w, W         what was pushed, when and by whom; restores one, asks first",
      "g, G         gains and thresholds of the running program; Enter pushes them",
      "m, M         another steers it: ask, or take it over; asked: give it, or refuse",
      "q, Ctrl-C    quit; the robots go on. Ctrl-Z: back to the shell, fg: here again",
      "",
      "Pushes, p to g above, need a monitor. Signs of states: ● a break point, where",
      "the robot stops; ■ a lock, where it waits until it is let through.",
      "A robot that was not heard for 2 s is silent and grey; its age is in the table.",
      "A bar is a variable's certainty now; it decays until a schema writes it again.",
      "The curve beside it: bits, a force's length, a shaft's speed, how certain a",
      "position is. LEAST SURE: the valid variable that it is least certain of.",
      "TICK: the longest time lately that a control tick took, in microseconds."};
  Sheet sheet{.title = "Keys", .lines = {}, .keys = "q quits here, too; any other key goes back"};
  for (const char* line : kLines) sheet.lines.push_back({line});
  return sheet;
}

}  // namespace galilean::monitor::top
