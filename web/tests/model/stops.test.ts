// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { Breaks_Constants } from "../../src/feed/messages";
import { stopAt } from "../../src/model/stops";
import { breaks, point, robotOf, state, T0_MS, told, transition } from "./told";

const { BREAK_POINT, STEP, TEAM } = Breaks_Constants;
const AT = { stopped: true, stopped_at: 7n, stopped_by: BREAK_POINT, break_robot: "io", break_point: point("wander", "grab"), author: "Anna" };
const CHANGE = { ...transition(7, "grab"), from_state: "wander" };
const WORDS = "stopped at wander → grab (Anna's break point)";
type Told = [string, unknown, number];

const robot = (...messages: Told[]) => robotOf(told(messages));
const events = (...messages: Told[]) => robot(["/io/breaks", breaks(), T0_MS], ["/io/state", state(), T0_MS], ...messages).events.map(({ kind, words }) => [kind, words]);

describe("what stopped a robot", () => {
  const stop: Told = ["/io/breaks", breaks(AT), T0_MS + 100];
  const held: Told = ["/io/state", state({ held: true }), T0_MS + 100];
  const change: Told = ["/io/transition", CHANGE, T0_MS + 100];

  it("is one event, whichever message comes first", () => {
    expect(events(change, stop, held)).toEqual([["stopped", WORDS]]);
    expect(events(change, held, stop)).toEqual([["stopped", WORDS]]);
  });
  it("is told again where it stops elsewhere, and not where it only tells so again", () => {
    const next: Told = ["/io/breaks", breaks({ ...AT, stopped_at: 8n, stopped_by: STEP }), T0_MS + 3000];
    expect(events(change, held, stop, stop, next)).toEqual([["stopped", WORDS], ["stopped", "stopped after a step"]]);
  });
  it("is told again where it is another robot's break point", () => {
    const of = (break_robot: string, at_ms: number): Told => ["/io/breaks", breaks({ ...AT, stopped_at: 0n, stopped_by: TEAM, break_robot }), at_ms];
    const words = (name: string) => `stopped by ${name}'s break point wander → grab, set by Anna`;
    expect(events(held, of("ganymede", T0_MS + 100), of("ganymede", T0_MS + 1100), of("callisto", T0_MS + 3000))).toEqual([["stopped", words("ganymede")], ["stopped", words("callisto")]]);
  });
  it("leaves a hold that was before it, and a robot that goes on", () => {
    const [early, on]: [Told, Told] = [["/io/state", state({ held: true }), T0_MS - 5000], ["/io/state", state(), T0_MS - 4000]];
    expect(events(early, on, change, held, stop).map(([kind]) => kind)).toEqual(["held", "resumed", "stopped"]);
    expect(events(change, held, stop, ["/io/breaks", breaks(), T0_MS + 4000], ["/io/state", state(), T0_MS + 4000]).at(-1)).toEqual(["resumed", "was told to go on"]);
  });
  it("is no event for a page that comes later: nobody knows when it was", () => {
    expect(robot(stop, ["/io/state", state({ held: true }), T0_MS + 200]).events).toEqual([]);
  });
  it("stands at the change of state that it was, also when the robot has gone on", () => {
    const later = robot(change, stop, ["/io/breaks", breaks(), T0_MS + 5000]);
    expect(stopAt(later, CHANGE)).toBe("break point wander → grab, set by Anna");
    expect(stopAt(later, { ...CHANGE, number: 8n })).toBeUndefined();
  });
  it("is none of a change that has the same number after a restart", () => {
    expect(stopAt(robot(change, stop), transition(7, "rest", T0_MS + 60_000))).toBeUndefined();
  });
  it("is none of another robot's break point, which no change of its own is", () => {
    expect(robot(["/io/breaks", breaks({ ...AT, stopped_at: 0n, stopped_by: TEAM, break_robot: "ganymede" }), T0_MS]).stops?.size).toBe(0);
  });
  it("has not happened yet where a recording's time goes back", () => {
    const back = robot(["/io/state", state({ at_ms: T0_MS, transitions: 7n }), T0_MS], change, stop, ["/io/state", state({ at_ms: T0_MS - 60_000, transitions: 2n }), T0_MS + 200]);
    expect(back.stops?.size).toBe(0);
  });
});
