// SPDX-License-Identifier: BSD-3-Clause
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { type BreakPoint_Constants, type Breaks, Breaks_Constants } from "../../src/feed/messages";
import { breakReason, changeOf, changeWords, kindAt, placeWords, standReason, stopperWords, waitOf } from "../../src/model/breaks";
import { breaks, point, state, T0_MS, time, transition } from "./told";

const { BREAK_POINT, STEP, TEAM } = Breaks_Constants;
const AT = { stopped: true, stopped_at: 7n, stopped_by: BREAK_POINT, break_robot: "io", break_point: point("", "grab"), author: "Anna" };
const OF_GANYMEDE = { ...AT, stopped_at: 0n, stopped_by: TEAM, break_robot: "ganymede", break_point: point("wander", "grab", "stop_team") };
const UNKNOWN = breaks().break_point;
const robot = (changes: Partial<Breaks>, transitions = [{ ...transition(7, "grab"), from_state: "wander" }]) =>
  ({ breaks: { value: breaks(changes), received_ms: T0_MS }, transitions });
const reason = (changes: Partial<Breaks>, transitions?: ReturnType<typeof transition>[]) => breakReason(robot(changes, transitions), T0_MS);

describe("what a part of the graph is for a break point", () => {
  it("a state is entered from anywhere, an arrow leads from one to another", () => {
    expect(changeOf("grab")).toEqual({ from: "", to: "grab" });
    expect(changeOf("wander → grab")).toEqual({ from: "wander", to: "grab" });
  });
  it("is said in the words that robots and the terminal have, with another arrow", () => {
    const told = readFileSync(new URL("../fixture/state_changes.txt", import.meta.url), "utf8").trimEnd().replaceAll("->", "→").split("\n");
    expect(told.length).toBe(4);
    for (const line of told) {
      const [from, to, ...words] = line.split("|") as [string, string, string, string];
      expect([changeWords({ from, to }), placeWords({ from, to })]).toEqual(words);
    }
  });
  it("has the kind that the robot tells of just these two states", () => {
    const told = breaks({ points: [point("wander", "grab", "lock"), point("", "grab")] });
    expect(kindAt(told, changeOf("grab"))).toBe("stop");
    expect(kindAt(told, changeOf("wander → grab"))).toBe("lock");
    expect(kindAt(told, changeOf("rest → grab"))).toBeUndefined();
    expect(kindAt(undefined, changeOf("grab"))).toBeUndefined();
    expect(kindAt(breaks({ points: [{ ...point("", "grab"), kind: 9 as BreakPoint_Constants }] }), changeOf("grab"))).toBeUndefined();
  });
});

describe("why a robot stands", () => {
  it("is nothing where no break point, step or lock keeps it", () => {
    expect(breakReason({ transitions: [] }, T0_MS)).toBeUndefined();
    expect(reason({ points: [point("", "grab")] })).toBeUndefined();
  });
  it("is where it was stopped, and by whose break point", () => {
    expect(reason(AT)).toBe("stopped at wander → grab (Anna's break point)");
    expect(reason(AT, [])).toBe("stopped on entering grab (Anna's break point)");
    expect(reason({ ...AT, break_point: point("rest", "grab") }, [])).toBe("stopped at rest → grab (Anna's break point)");
    expect(reason({ ...AT, break_point: UNKNOWN, author: "" }, [])).toBe("stopped at a break point");
  });
  it("is where a step led", () => {
    expect(reason({ ...AT, stopped_by: STEP })).toBe("stepped into grab");
    expect(reason({ ...AT, stopped_by: STEP }, [])).toBe("stopped after a step");
  });
  it("is another robot's break point where that stopped the team", () => {
    expect(reason(OF_GANYMEDE)).toBe("stopped by ganymede's break point wander → grab, set by Anna");
    expect(reason({ ...OF_GANYMEDE, break_point: UNKNOWN, author: "" })).toBe("stopped by ganymede's break point");
  });
  it("is not read out of names that look like its own words", () => {
    expect(reason({ ...AT, break_point: point("a step", "x -> y") }, [])).toBe("stopped at a step → x -> y (Anna's break point)");
  });
  it("is said to be unknown where a later release tells it", () => {
    expect(reason({ ...AT, stopped_by: 99 as Breaks_Constants })).toBe("stopped by a reason that this release does not know, set by Anna");
  });
  it("is the lock that it waits at, and for how long", () => {
    const waits = { waits_at_from: "grab", waits_at_to: "move", waits_since: time(T0_MS - 2000) };
    expect(breakReason(robot(waits), T0_MS + 1000)).toBe("waits at the lock grab → move for 3.0 s");
    expect(standReason(robot(waits))).toBe("waits at the lock grab → move");
    expect(waitOf(breaks(waits))).toEqual({ from: "grab", to: "move" });
    expect(waitOf(breaks())).toBeUndefined();
    expect(reason({ ...AT, ...waits })).toBe("stopped at wander → grab (Anna's break point)");
  });
  it("is the fault that it is held after, which it says among its problems", () => {
    const why = "held: the serial line was gone for 3.2 s; resume it, or push a bumper.";
    const told = (held: boolean) => ({ ...robot({}), state: { value: state({ held, problems: ["camera: gone", why] }), received_ms: T0_MS } });
    expect(breakReason(told(true), T0_MS)).toBe(why);
    expect(standReason(told(true))).toBe(why);
    expect(breakReason(told(false), T0_MS)).toBeUndefined();
    expect(breakReason({ ...told(true), breaks: undefined }, T0_MS)).toBe(why);
  });
  it("is a step that is under way", () => {
    expect(reason({ stepping: true })).toBe("goes on until its next change of state");
    expect(standReason(robot({ stepping: true }))).toBeUndefined();
  });
  it("names what stopped it, and whose that was", () => {
    expect(stopperWords(breaks(AT))).toBe("break point on entering grab, set by Anna");
    expect(stopperWords(breaks({ ...AT, stopped_by: STEP }))).toBe("a step, ordered by Anna");
    expect(stopperWords(breaks({ stopped_by: STEP }))).toBe("a step");
  });
});
