// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Forces, Program } from "../../src/feed/messages";
import { drawnForces } from "../../src/map/forces";
import { catalog } from "../fixture/catalogs";
import { time } from "../model/told";

const force = (schema: string, x: number, y: number, gain = 1, active = true) => ({ schema, variable: schema, x, y, gain, active });
const forces = (...items: Forces["items"]): Forces => ({ stamp: time(0), robot: "io", tick: 0n, items });
const program = {
  files: [{ path: "a.bhdl", text: 'motor_schemas:\n  combine_forces: name: "search" force_variable: "next" end\nend\n' }],
} as unknown as Program;

describe("forces on the map", () => {
  it("are turned from the robot's frame, x right and y ahead, into the map's", () => {
    const [ahead, right] = drawnForces(forces(force("ahead", 0, 1), force("right", 1, 0)), undefined, undefined, Math.PI / 2);
    expect([ahead!.x, ahead!.y]).toEqual([expect.closeTo(0, 9), expect.closeTo(1, 9)]);
    expect([right!.x, right!.y]).toEqual([expect.closeTo(1, 9), expect.closeTo(0, 9)]);
  });

  it("count times their gain, and only while their schema runs", () => {
    const drawn = drawnForces(forces(force("a", 0, 1, 0.5), force("b", 0, 1, 1, false)), undefined, undefined, 0);
    expect(drawn.map(({ schema, strength }) => [schema, strength])).toEqual([
      ["a", 0.5],
      ["sum", 0.5],
    ]);
  });

  it("have the sum that the program itself makes, where it makes one", () => {
    const drawn = drawnForces(forces(force("a", 0, 1), force("search", 0, 0.6)), program, catalog, 0);
    expect(drawn.map(({ schema, isSum }) => [schema, isSum])).toEqual([
      ["a", false],
      ["search", true],
    ]);
  });
});
