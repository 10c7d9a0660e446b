// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { placed } from "../../src/graph/machine_places";

type Way = [string, string];
const cells = (names: string[], start: string, ways: Way[], columns: number) =>
  Object.fromEntries([...placed(names, start, ways, columns)].map(([name, { column, row }]) => [name, [column, row]]));

describe("the places of a machine's states", () => {
  it("go down a single column in the order in which they are met", () => {
    const ways: Way[] = [["start", "wander"], ["wander", "grab"], ["grab", "drop"]];
    expect(cells(["drop", "grab", "wander", "start"], "start", ways, 1)).toEqual({ start: [0, 0], wander: [0, 1], grab: [0, 2], drop: [0, 3] });
  });
  it("keep the start first, wherever it is listed and however it is tied up", () => {
    const names = Array.from({ length: 9 }, (_, i) => `s${i}`);
    const ways = names.flatMap((name, i): Way[] => [[name, names[(i + 4) % 9]!], [name, names[(i * 5 + 2) % 9]!]]);
    expect(cells(names, "s6", ways, 3).s6).toEqual([0, 0]);
  });
  it("bring together what is tied together", () => {
    const names = ["hub", "a", "b", "c", "d", "far"];
    const ways: Way[] = [["hub", "a"], ["a", "b"], ["b", "c"], ["c", "d"], ["hub", "far"], ["far", "hub"]];
    const { hub, far } = cells(names, "hub", ways, 3) as Record<string, [number, number]>;
    expect(Math.abs(hub![0] - far![0]) + Math.abs(hub![1] - far![1])).toBe(1);
  });
  it("never share a cell, and leave nobody out who is never met", () => {
    const names = ["a", "b", "lonely", "c"];
    const all = Object.values(cells(names, "a", [["a", "b"], ["b", "c"]], 2)).map(String);
    expect(new Set(all).size).toBe(4);
  });
  it("begin with the first state where the start is none of them", () => {
    expect(cells(["a", "b"], "gone", [["a", "b"]], 2)).toEqual({ a: [0, 0], b: [1, 0] });
  });
  it("are the same each time", () => {
    const names = Array.from({ length: 12 }, (_, i) => `s${i}`);
    const ways = names.map((name, i): Way => [name, names[(i * 7 + 3) % 12]!]);
    expect(cells(names, "s0", ways, 3)).toEqual(cells(names, "s0", ways, 3));
  });
});
