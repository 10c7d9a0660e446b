// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { loopOf } from "../../src/model/loops";
import type { StateBar, TrailPoint } from "../../src/model/model";
import { T0_MS } from "./told";

/** The stays in `states`, again and again, each as long as `stays_ms` says in turn. */
function goingRound(states: readonly string[], rounds: number, stays_ms: readonly number[]): StateBar[] {
  let from_ms = T0_MS;
  return Array.from({ length: states.length * rounds + 1 }, (_, i) => {
    const bar = { number: BigInt(i), state: states[i % states.length]!, from_ms };
    from_ms += stays_ms[i % stays_ms.length]!;
    return bar;
  });
}
const GRABBING = ["grab", "backup", "remember", "wander"];
const nothing = { deposits_ms: [], trail: [] };
const endOf = (bars: readonly StateBar[]) => bars.at(-1)!.from_ms + 100;
const loop = (bars: readonly StateBar[], success: { deposits_ms: number[]; trail: TrailPoint[] } = nothing, order: string[] = GRABBING) => loopOf(bars, success, order, endOf(bars));
const going = (mps: number, for_s: number): TrailPoint[] => Array.from({ length: for_s * 5 }, (_, i) => ({ x_m: (mps * i) / 5, y_m: 0, at_ms: T0_MS + i * 200 }));

describe("a robot that goes round without getting anywhere", () => {
  const bars = goingRound(GRABBING, 14, [180]);

  it("is found, with its states in the program's order and how often it went round", () => {
    expect(loop(bars)).toEqual({ states: GRABBING, rounds: 14, from_ms: T0_MS });
    expect(loop(bars.slice(0, -2))?.states, "wherever it is just now").toEqual(GRABBING);
    expect(loop(bars, nothing, [])?.states, "without a program by name").toEqual(["backup", "remember", "wander", "grab"]);
  });
  it("is found after a time of good work, and counted from where the loop begins", () => {
    const work = [["start", 9000], ["wander", 8000], ["move", 6000]].map(([state, ago_ms], i) => ({ number: BigInt(i - 3), state: String(state), from_ms: T0_MS - Number(ago_ms) }));
    expect(loop([...work, ...bars])).toMatchObject({ rounds: 14, from_ms: T0_MS });
  });
  it("is found at ten rounds a second, too", () => {
    expect(loop(goingRound(["grab", "backup"], 60, [50]))?.rounds).toBe(60);
  });
  it("is found though it shifts about on the spot", () => {
    const shifting = going(0.02, 10);
    expect(loop(bars, { deposits_ms: [], trail: shifting })).toBeDefined();
  });
  it("is let go once it stays in a state or goes another way", () => {
    expect(loopOf(bars, nothing, GRABBING, bars.at(-1)!.from_ms + 3500)).toBeUndefined();
    expect(loop([...bars, { number: BigInt(bars.length), state: "free", from_ms: endOf(bars) }])).toBeUndefined();
  });
  it("is not made up across changes that were not heard", () => {
    const holed = bars.map((bar, i) => ({ ...bar, number: bar.number + (i > 30 ? 1n : 0n) }));
    expect(loop(holed)).toBeUndefined();
  });
});

describe("no loop is", () => {
  it("sitting and spinning, then moving a little, however often", () => {
    expect(loop(goingRound(["wander_for_trash", "spin_for_trash"], 40, [5000, 7000]))).toBeUndefined();
  });
  it("avoiding, which comes at long and at short intervals", () => {
    expect(loop(goingRound(["wander", "avoid"], 12, [900, 400, 6000, 700, 2500, 400]))).toBeUndefined();
  });
  it("following a line by two states while it drives along", () => {
    const bars = goingRound(["left_of_line", "right_of_line"], 20, [400]);
    expect(loop(bars), "standing it would be one").toBeDefined();
    expect(loop(bars, { deposits_ms: [], trail: going(0.25, 16) })).toBeUndefined();
  });
  it("following a line that leads round, however long", () => {
    const bars = goingRound(["left_of_line", "right_of_line"], 200, [400]);
    const round: TrailPoint[] = Array.from({ length: 160 * 5 }, (_, i) => ({ x_m: 0.5 * Math.cos(i * 0.08), y_m: 0.5 * Math.sin(i * 0.08), at_ms: T0_MS + i * 200 }));
    for (let seen = 40; seen <= bars.length; seen += 5) {
      const until_ms = endOf(bars.slice(0, seen));
      const trail = round.filter(({ at_ms }) => at_ms <= until_ms && at_ms > until_ms - 60_000);
      expect(loop(bars.slice(0, seen), { deposits_ms: [], trail })).toBeUndefined();
    }
  });
  it("a bit that flickers on its threshold for a moment", () => {
    expect(loop(goingRound(["near", "far"], 20, [40]))).toBeUndefined();
  });
  it("a few hasty rounds", () => {
    expect(loop(goingRound(GRABBING, 7, [250]))).toBeUndefined();
  });
  it("work that brings a piece home within it", () => {
    const bars = goingRound(GRABBING, 14, [180]);
    expect(loop(bars, { deposits_ms: [bars.at(-20)!.from_ms], trail: [] })).toBeUndefined();
    expect(loop(bars, { deposits_ms: [T0_MS - 100], trail: [] }), "success before it does not excuse it").toBeDefined();
  });
  it("a robot that waits in its first state", () => {
    expect(loop([{ number: 0n, state: "start", from_ms: T0_MS }])).toBeUndefined();
    expect(loopOf([], nothing, [], T0_MS)).toBeUndefined();
  });
});
