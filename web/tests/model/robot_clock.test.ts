// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { onPageClock_ms } from "../../src/model/robot_clock";
import { robotOf, state, T0_MS, time, told, transition } from "./told";

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

it("forgets what has not happened yet when a recording begins again, and hears it as it happens", () => {
  const change = (number: number, second: number): [string, unknown, number] => ["/io/transition", transition(number, `state${number}`, T0_MS + second * 1000), T0_MS + 90_000 + second * 1000];
  const at = (second: number, transitions: bigint): [string, unknown, number] => ["/io/state", state({ at_ms: T0_MS + second * 1000, transitions }), T0_MS + 90_000 + second * 1000];
  const once = [at(0, 1n), change(1, 0), change(2, 5), change(3, 10), at(15, 3n)];
  const again = told([...once, at(1, 1n)]);
  expect(robotOf(again).transitions.map(({ number }) => Number(number))).toEqual([1]);
  expect(robotOf(told([change(2, 5)], again)).transitions.map(({ number }) => Number(number))).toEqual([1, 2]);
});
