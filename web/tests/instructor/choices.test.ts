// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { faultsOf, faultWords, ofKind, PARTS, PIECES, pushHeading_rad } from "../../src/instructor/choices";

const body = (name: string, kind: string, heading_rad = 0) => ({ name, kind, x_m: 0, y_m: 0, heading_rad, held_by: "" });

describe("parts that break", () => {
  it("are those that the simulation knows", () => {
    expect(PARTS.map(([part]) => part)).toEqual(["camera", "serial_line", "board", "left_wheel", "right_wheel", ...Array.from({ length: 8 }, (_, i) => `bumper_${i}`)]);
  });
  it("are stuck only where they are bumpers", () => {
    expect(faultsOf("bumper_3")).toEqual(["dead", "stuck"]);
    expect(faultsOf("camera")).toEqual(["dead"]);
  });
  it("are told in the operator's words", () => {
    expect(faultWords({ robot: "io", part: "bumper_0", fault: "stuck" })).toBe("io's front bumper is stuck");
  });
});

it("pieces are cans, cups and wads, and neither baskets nor robots", () => {
  expect(ofKind([body("io", "robot"), body("can_1", "can"), body("basket_1", "basket"), body("wad_2", "wad")], PIECES)).toEqual(["can_1", "wad_2"]);
});

it("a push goes by where the robot heads", () => {
  const bodies = [body("io", "robot", Math.PI / 2)];
  expect(pushHeading_rad(bodies, "io", "forward")).toBeCloseTo(Math.PI / 2);
  expect(Math.abs(pushHeading_rad(bodies, "io", "left"))).toBeCloseTo(Math.PI);
  expect(pushHeading_rad(bodies, "io", "right")).toBeCloseTo(0);
});
