// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Machine } from "../../src/feed/parts";
import { fitOf, KeptRooms } from "../../src/graph/kept_rooms";

function machine(...names: string[]): Machine {
  return {
    start_state: names[0]!,
    states: names.map((name) => ({ name, file: "a.bhdl", line: 1, perceptual_schemas: [], motor_schemas: [] })),
    transitions: [],
  };
}
const TALL = { width: 300, height: 500 };
const WIDE = { width: 900, height: 200 };

describe("the room that a machine is laid out for", () => {
  it("stays that of its first showing when the panel changes size", () => {
    const rooms = new KeptRooms();
    expect(rooms.roomFor(machine("a", "b"), TALL)).toEqual(TALL);
    expect(rooms.roomFor(machine("a", "b"), WIDE)).toEqual(TALL);
  });
  it("is another machine's own", () => {
    const rooms = new KeptRooms();
    rooms.roomFor(machine("a", "b"), TALL);
    expect(rooms.roomFor(machine("a", "b", "c"), WIDE)).toEqual(WIDE);
  });
  it("is not that of a panel which is not shown yet", () => {
    const rooms = new KeptRooms();
    rooms.roomFor(machine("a"), { width: 0, height: 0 });
    expect(rooms.roomFor(machine("a"), WIDE)).toEqual(WIDE);
  });
  it("becomes another when the machine is laid out anew", () => {
    const rooms = new KeptRooms();
    rooms.roomFor(machine("a"), TALL);
    rooms.layOutFor(machine("a"), WIDE);
    expect(rooms.roomFor(machine("a"), TALL)).toEqual(WIDE);
  });
});

describe("the scale of a layout", () => {
  const laid = { width: 280, height: 400 };
  it("is 1 in its own room, and grows with it", () => {
    expect(fitOf(laid, TALL, TALL, 0.85)).toBe(1);
    expect(fitOf(laid, TALL, { width: 600, height: 1000 }, 0.85)).toBe(2);
  });
  it("shrinks with the room, to where names are still read", () => {
    expect(fitOf(laid, TALL, { width: 300, height: 360 }, 0.85)).toBeCloseTo(0.9);
    expect(fitOf(laid, TALL, WIDE, 0.85)).toBe(0.85);
  });
});
