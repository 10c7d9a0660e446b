// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { drawnBars, labelled, markLabels, namedPart, withBar, withProgram } from "../../src/model/timeline";
import type { Team } from "../../src/model/model";
import { applyAll } from "../../src/model/reduce";
import { withSilencesUntil } from "../../src/model/silence";
import { mapRobot, robotOf, state, T0_MS, time, told, transition } from "./told";

describe("the timeline", () => {
  const changed = state({ at_ms: T0_MS + 1000, state: "wander", transitions: 1n });

  it("draws a change once, told by transition and state in either order", () => {
    const first = state();
    const change = transition(1, "wander", T0_MS + 1000);
    const one = told([["/io/state", first, T0_MS], ["/io/transition", change, T0_MS + 1000], ["/io/state", changed, T0_MS + 1010]]);
    const other = told([["/io/state", first, T0_MS], ["/io/state", changed, T0_MS + 1000], ["/io/transition", change, T0_MS + 1010]]);
    for (const team of [one, other]) expect(robotOf(team).bars.map((bar) => bar.state)).toEqual(["start", "wander"]);
  });
  it("keeps one bar while a state lasts, however its time of entry jitters", () => {
    const again = state({ at_ms: T0_MS + 5000, state: "wander", transitions: 1n });
    const team = told([["/io/state", changed, T0_MS + 1000], ["/io/state", again, T0_MS + 5000]]);
    expect(robotOf(team).bars).toHaveLength(1);
  });
  it("shows the states that passed between two samples", () => {
    const team = told([
      ["/io/state", state(), T0_MS],
      ["/io/transition", transition(1, "wander", T0_MS + 20), T0_MS + 20],
      ["/io/transition", transition(2, "grab", T0_MS + 40), T0_MS + 40],
    ]);
    expect(drawnBars(robotOf(team).bars, T0_MS + 10, T0_MS + 100)).toEqual([
      { state: "start", from_ms: T0_MS + 10, to_ms: T0_MS + 20 },
      { state: "wander", from_ms: T0_MS + 20, to_ms: T0_MS + 40 },
      { state: "grab", from_ms: T0_MS + 40, to_ms: T0_MS + 100 },
    ]);
  });
  it("puts a change that comes late between those around it", () => {
    const bar = (number: number) => ({ number: BigInt(number), state: `s${number}`, from_ms: T0_MS + number });
    const bars = [bar(1), bar(2), bar(4), bar(5)].reduce(withBar, [] as readonly ReturnType<typeof bar>[]);
    expect(withBar(bars, bar(3)).map(({ state: name }) => name)).toEqual(["s1", "s2", "s3", "s4", "s5"]);
  });
  it("marks where the program changed, once", () => {
    const change = (hash: string) => ({ hash, name: hash, at_ms: T0_MS });
    const list = ["a", "a", "b", "a"].map(change).reduce(withProgram, [] as readonly ReturnType<typeof change>[]);
    expect(list.map(({ hash }) => hash)).toEqual(["a", "b", "a"]);
  });
  it("shortens a name to the room that its bar has", () => {
    expect(labelled("wander_for_trash", 200)).toBe("wander_for_trash");
    expect(labelled("wander_for_trash", 68).length).toBeLessThanOrEqual(10);
    expect(labelled("wander_for_trash", 1).length).toBeLessThanOrEqual(2);
  });
  it("goes on when a robot starts again and counts from nothing", () => {
    const reborn = state({ at_ms: T0_MS + 60_000, state: "start", transitions: 0n });
    const team = told([["/io/state", changed, T0_MS + 1000], ["/io/state", reborn, T0_MS + 60_000]]);
    expect(robotOf(team).bars.map((bar) => bar.state)).toEqual(["wander", "start"]);
  });
  describe("of a robot that was silent", () => {
    const reborn = state({ at_ms: T0_MS + 13_000, state: "start", transitions: 0n });
    const dead = { from_ms: T0_MS + 1000, to_ms: T0_MS + 13_000 };
    const alive = told([["/io/state", changed, T0_MS + 1000]]);
    const drawn = (team: Team) => drawnBars(robotOf(team).bars, T0_MS, T0_MS + 20_000, robotOf(team).silences);

    it("leaves a gap that stays, whatever comes after it", () => {
      const back = (message: typeof reborn) => applyAll(alive, [{ topic: "/io/state", message, received_ms: dead.to_ms, count: 1, pauses: [dead] }]);
      expect(drawn(back(reborn))).toEqual([{ state: "start", from_ms: dead.to_ms, to_ms: T0_MS + 20_000 }]);
      const changedMeanwhile = told([["/io/transition", transition(2, "grab", T0_MS + 5000), dead.to_ms]], back({ ...changed, stamp: reborn.stamp }));
      expect(drawn(changedMeanwhile)).toEqual([{ state: "grab", from_ms: dead.to_ms, to_ms: T0_MS + 20_000 }]);
    });
    it("ends the bar where the monitor last heard it, by the monitor's age", () => {
      const objects = (at_ms: number, age_s: number) => ["/team/objects", { stamp: time(at_ms), objects: [], robots: [mapRobot({ silent: true, age_s })] }, at_ms] as [string, unknown, number];
      const back = told([objects(T0_MS + 5000, 3), objects(T0_MS + 9000, 7), ["/io/state", { ...changed, stamp: time(T0_MS + 10_000) }, T0_MS + 10_000]], alive);
      expect(drawn(back)).toEqual([{ state: "wander", from_ms: T0_MS + 1000, to_ms: T0_MS + 2000 }, { state: "wander", from_ms: T0_MS + 9000, to_ms: T0_MS + 20_000 }]);
    });
    it("keeps the gap where the connection is lost meanwhile", () => {
      const back = told([["/io/state", reborn, dead.to_ms]], withSilencesUntil(alive, T0_MS + 9000));
      expect(robotOf(back).silences).toEqual([{ from_ms: T0_MS + 1000, to_ms: T0_MS + 9000 }]);
      expect(withSilencesUntil(alive, T0_MS + 2000)).toBe(alive);
    });
  });
  it("puts changes that were heard before the first state where they happened", () => {
    const late = T0_MS + 30_000;
    const team = told([
      ["/io/transition", transition(1, "wander", T0_MS + 1000), late],
      ["/io/transition", transition(2, "grab", T0_MS + 9000), late],
      ["/io/state", state({ at_ms: late, state: "grab", transitions: 2n }), late],
    ]);
    expect(drawnBars(robotOf(team).bars, T0_MS, late)).toEqual([
      { state: "wander", from_ms: T0_MS + 1000, to_ms: T0_MS + 9000 },
      { state: "grab", from_ms: T0_MS + 9000, to_ms: late },
    ]);
  });
});

describe("the name of a bar", () => {
  it("stands in the longest part that no gap covers", () => {
    const bar = { from_ms: 0, to_ms: 100 };
    expect(namedPart(bar, [])).toEqual(bar);
    expect(namedPart(bar, [{ from_ms: 20, to_ms: 30 }])).toEqual({ from_ms: 30, to_ms: 100 });
    expect(namedPart(bar, [{ from_ms: 10, to_ms: 20 }, { from_ms: 70, to_ms: 200 }])).toEqual({ from_ms: 20, to_ms: 70 });
    expect(namedPart(bar, [{ from_ms: -50, to_ms: 200 }])).toEqual({ from_ms: 0, to_ms: 0 });
  });
});

describe("the labels of marks", () => {
  it("end before the next mark, and are left out where they have no room", () => {
    const marks = [{ x_px: 0, words: "office_cleanup a3f9, operator" }, { x_px: 100, words: "office b2, me" }, { x_px: 110, words: "wander c1" }];
    const labels = markLabels(marks, 400);
    expect(labels[0]).toContain("…");
    expect(labels.slice(1)).toEqual(["", "wander c1"]);
  });
});
