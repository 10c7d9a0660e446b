// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { LaidArrow, LaidState } from "../../src/graph/machine_layout";
import { neighbour, wayOut } from "../../src/graph/machine_neighbour";

const box = (name: string, x: number, y: number): LaidState => ({ name, x, y, width: 40, height: 20 }) as LaidState;

describe("arrow keys in the state machine", () => {
  const states = [box("wander", 0, 0), box("grab", 100, 0), box("drop", 200, 0), box("back_up", 100, 80), box("halt", 0, -60)];

  it("lead to the nearest state on that side", () => {
    expect(neighbour(states, "wander", "ArrowRight")).toBe("grab");
    expect(neighbour(states, "drop", "ArrowLeft")).toBe("grab");
    expect(neighbour(states, "grab", "ArrowDown")).toBe("back_up");
    expect(neighbour(states, "wander", "ArrowUp")).toBe("halt");
  });
  it("prefer what lies straight ahead to what is nearer but aside", () => {
    const aside = [box("here", 0, 0), box("aside", 50, 60), box("ahead", 110, 0)];
    expect(neighbour(aside, "here", "ArrowRight")).toBe("ahead");
  });
  it("lead nowhere past the last one, from what is not there, or by another key", () => {
    expect(neighbour(states, "drop", "ArrowRight")).toBeUndefined();
    expect(neighbour(states, "gone", "ArrowRight")).toBeUndefined();
    expect(neighbour(states, "wander", "Enter")).toBeUndefined();
  });
  it("go by the boxes' middles, whatever their sizes", () => {
    const wide = { name: "wide", x: -100, y: 50, width: 240, height: 20 } as LaidState;
    expect(neighbour([box("here", 0, 0), wide, box("far", 0, 200)], "here", "ArrowDown")).toBe("wide");
  });
});

describe("page keys in the state machine", () => {
  const arrows = [["wander", "grab"], ["grab", "drop"], ["wander", "halt"]].map(([from, to]) => ({ from, to }) as LaidArrow);
  const to = (arrow: string | undefined, key: string) => wayOut(arrows, "wander", arrow, key)?.to;

  it("lead round and round the arrows that leave a state", () => {
    expect(to(undefined, "PageDown")).toBe("grab");
    expect(to("wander → grab", "PageDown")).toBe("halt");
    expect(to("wander → halt", "PageDown")).toBe("grab");
    expect(to(undefined, "PageUp")).toBe("halt");
    expect(to("wander → grab", "PageUp")).toBe("halt");
  });
  it("lead nowhere from a state that nothing leaves, or by another key", () => {
    expect(wayOut(arrows, "drop", undefined, "PageDown")).toBeUndefined();
    expect(to(undefined, "ArrowDown")).toBeUndefined();
  });
});
