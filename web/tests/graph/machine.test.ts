// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Machine } from "../../src/feed/parts";
import { labelLines, layOut } from "../../src/graph/machine_layout";

function machine(...ways: [from: string, to: string, bits?: string][]): Machine {
  const names = [...new Set(ways.flatMap(([from, to]) => [from, to]))];
  return {
    start_state: names[0]!,
    states: names.map((name, i) => ({ name, file: "a.bhdl", line: i, perceptual_schemas: ["look"], motor_schemas: [] })),
    transitions: ways.map(([from_state, to_state, bits_variable = "bits"], i) => ({
      from_state, to_state, bits_variable, file: "a.bhdl", line: i, bit_index: 0, bit_value: true, bit_update: "same", reset_variables: [],
    })),
  };
}
const ROOM = { width: 368, height: 490 };
const office = machine(["start", "wander"], ["wander", "move_to_trash"], ["move_to_trash", "wander"], ["move_to_trash", "grab"]);

describe("a machine's layout", () => {
  it("places every state within its bounds, none on another, the start on top", () => {
    const { states, width, height } = layOut(office, ROOM);
    expect(states.map(({ name }) => name).sort()).toEqual(["grab", "move_to_trash", "start", "wander"]);
    for (const a of states) {
      expect(a.x >= 0 && a.y >= 0 && a.x + a.width <= width && a.y + a.height <= height).toBe(true);
      for (const b of states) {
        const apart = a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
        expect(a === b || apart).toBe(true);
      }
    }
    expect([...states].sort((a, b) => a.y - b.y)[0]?.name).toBe("start");
  });
  it("draws all ways from one state to another as one arrow that knows them all", () => {
    const twice = layOut(machine(["a", "b", "seen"], ["a", "b", "felt"]), ROOM);
    expect(twice.arrows).toHaveLength(1);
    expect(twice.arrows[0]?.transitions.map((way) => way.bits_variable)).toEqual(["seen", "felt"]);
  });
  it("draws a state that leads to itself, and leaves out a way to nowhere", () => {
    const odd = machine(["a", "a"], ["a", "b"]);
    const { arrows } = layOut({ ...odd, states: odd.states.slice(0, 1) }, ROOM);
    expect(arrows.map(({ from, to }) => [from, to])).toEqual([["a", "a"]]);
  });
  it("holds twenty states of long names at full size in a laptop's panel", () => {
    const names = Array.from({ length: 20 }, (_, i) => `wander_for_trash_${i}`);
    const ways = names.flatMap((name, i): [string, string][] => [[name, names[(i + 1) % 20]!], [name, names[(i * 7 + 3) % 20]!]]);
    const { width, height, states } = layOut(machine(...ways), ROOM);
    expect(states).toHaveLength(20);
    expect(width).toBeLessThanOrEqual(ROOM.width + 1);
    expect(height).toBeLessThanOrEqual(ROOM.height + 1);
  });
  it("bends an arrow round a state that stands between", () => {
    const chain = layOut(machine(["a", "b"], ["b", "c"], ["a", "c"]), { width: 60, height: 400 });
    const [, b] = [...chain.states].sort((one, other) => one.y - other.y);
    const control = Number(/Q(-?[\d.]+)/.exec(chain.arrows.find(({ from, to }) => from === "a" && to === "c")!.path)?.[1]);
    expect(Math.abs(control - (b!.x + b!.width / 2))).toBeGreaterThan(b!.width / 2);
  });
  it("breaks long names near their middle", () => {
    expect(labelLines("wander_for_trashcan")).toEqual(["wander_for_", "trashcan"]);
    expect(labelLines("backup1")).toEqual(["backup1"]);
  });
});
