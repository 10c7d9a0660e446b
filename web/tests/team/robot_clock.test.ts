import { expect, it } from "vitest";
import { onPageClock_ms } from "../../src/team/robot_clock";
import { robotOf, state, T0_MS, time, told } from "./told";

it("puts a robot's times on the page's clock, whatever the robot's clock says", () => {
  const ahead_ms = 3_600_000;
  const robot = robotOf(told([["/io/state", state({ at_ms: T0_MS + ahead_ms }), T0_MS + 5]]));
  expect(onPageClock_ms(robot, time(T0_MS + ahead_ms - 4000))).toBe(T0_MS - 3995);
});

it("follows when a simulation starts its clock again", () => {
  const team = told([
    ["/io/state", state({ at_ms: T0_MS }), T0_MS],
    ["/io/state", state({ at_ms: 1000 }), T0_MS + 100],
  ]);
  expect(onPageClock_ms(robotOf(team), time(1000))).toBe(T0_MS + 100);
});
