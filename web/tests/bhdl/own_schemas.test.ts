// SPDX-License-Identifier: BSD-3-Clause
// A robot may have schemas that the page has never heard of: what they are, their roles alone tell.
import { describe, expect, it } from "vitest";
import type { Forces, MachineTransition, Program, Variable } from "../../src/feed/messages";
import { nearnessOf, triggersOf } from "../../src/machine/nearness";
import { drawnForces } from "../../src/map/forces";
import { detectorsOf, picturesOf, pictureOfVariables } from "../../src/vision/detectors";
import { ownCatalog } from "../fixture/catalogs";
import { T0_MS, time } from "../model/told";

const files = [
  {
    path: "own.bhdl",
    text: `perceptual_schemas:
  contours: name: "draw" drawn_on: "lines" end
  glow: name: "find" scene: "lines" found: "lamp" glow: 70 end
  in_reach: name: "reach" target: "lamp" odometer: "wheels" arm: 250 flags: "near" end
end
motor_schemas: steer: name: "steer" pulls: "left" weights: 2 brake: "slow" way: "way" end end`,
  },
];

describe("schemas of one's own", () => {
  it("add their picture to the robot's", () => {
    expect(picturesOf(ownCatalog)).toEqual(["camera", "contours"]);
  });

  it("have what they find drawn over the picture that they look at, and can be tuned", () => {
    expect([...pictureOfVariables(files, ownCatalog)]).toEqual([["lamp", "contours"]]);
    expect(detectorsOf(files, ownCatalog)).toMatchObject([
      { name: "find", picture: "contours", threshold: { level: 70, dark: false }, minArea_px: 4, attributes: { threshold: "glow", leastArea: "speck" } },
    ]);
  });

  it("tell how near they are to firing, in their own unit and at their own bit", () => {
    const variable = (name: string, type: Variable["type"], values: number[]): Variable =>
      ({ name, type, object_class: "", valid: true, certainty: 1, decay_per_s: 0, updated: time(T0_MS), values: Float64Array.from(values) });
    const variables = [variable("shaft", 1, [9, 9]), variable("wheels", 1, [1, 1]), variable("lamp", 3, [1, 1.5])];
    const condition: MachineTransition =
      { from_state: "a", to_state: "b", file: "", line: 1, bits_variable: "near", bit_index: 3, bit_value: true, bit_update: "same", reset_variables: [] };
    const now = { variables, age_ms: 0, in_state_s: 0, schemas: ["reach"] };
    expect(nearnessOf(condition, triggersOf(files, ownCatalog), now)).toEqual({ share: 0.5, text: "0.50 m away, fires at 0.25 m" });
  });

  it("are the sum of the forces to which they give gains", () => {
    const force = (schema: string, y: number, gain: number) => ({ schema, variable: schema, x: 0, y, gain, active: true });
    const forces: Forces = { stamp: time(0), robot: "io", tick: 0n, items: [force("left", 1, 2), force("steer", 0.5, 1)] };
    const drawn = drawnForces(forces, { files } as unknown as Program, ownCatalog, 0);
    expect(drawn.map(({ schema, strength, isSum }) => [schema, strength, isSum])).toEqual([["left", 2, false], ["steer", 0.5, true]]);
  });
});
