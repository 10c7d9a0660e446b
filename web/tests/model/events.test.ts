// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Score } from "../../src/feed/messages";
import { callsOn, contestBegan_ms } from "../../src/model/events";
import { robotOf, state, T0_MS, told } from "./told";

const kinds = (...states: Parameters<typeof state>[0][]) =>
  robotOf(told(states.map((changes, i) => ["/io/state", state(changes), T0_MS + i] as [string, unknown, number]))).events.map(({ kind, words }) => [kind, words]);

describe("a robot's events", () => {
  it("are read from how its state differs from the one before", () => {
    expect(kinds({ held: true }, { held: true }, { held: false })).toEqual([["resumed", "was told to go on"]]);
    expect(kinds({}, { problems: ["camera: gone"] }, {})).toEqual([["problem", "camera: gone"], ["well", "has no problem any more"]]);
    expect(kinds({}, { held: true })).toEqual([["held", "was told to hold, and stands still"]]);
    expect(kinds({}, { held: true, problems: ["held: the camera is gone"] })).toEqual([["problem", "held: the camera is gone"]]);
    expect(kinds({}, { out_of_service: true, overruns: 3 })).toEqual([["decommissioned", "was taken out of service"], ["late", "a tick began late (3 so far)"]]);
  });
  it("are none where it was well and stays so", () => {
    expect(kinds({}, {}, {})).toEqual([]);
  });
});

const score = (changes: Partial<Score>): Score => ({
  stamp: { sec: 0, nsec: 0 }, scenario: "office", phase: "running", elapsed_s: 0, remaining_s: 0, pieces: 24, deposited: 0, collisions: 0, points: 0,
  points_per_piece: 10, points_per_collision: -1, robots: [], calls: [], ...changes,
});

describe("the referee's calls", () => {
  it("have their place in time by when the contest began, whatever a message's delay", () => {
    const began = contestBegan_ms(contestBegan_ms(undefined, score({ elapsed_s: 10 }), 110_000), score({ elapsed_s: 11 }), 111_400);
    expect(began).toBe(100_000);
    const calls = [{ elapsed_s: 7, robot: "io", what: "deposited", points: 10 }, { elapsed_s: 8, robot: "callisto", what: "collision", points: -1 }];
    expect(callsOn("io", { value: score({ calls }), received_ms: 0 }, began)).toEqual([{ ...calls[0], at_ms: 107_000 }]);
  });
  it("stay where they are when the clock has stopped, and begin anew with a new contest", () => {
    expect(contestBegan_ms(100_000, score({ phase: "over", elapsed_s: 600 }), 900_000)).toBe(100_000);
    expect(contestBegan_ms(100_000, score({ elapsed_s: 0 }), 900_000)).toBe(900_000);
  });
});
