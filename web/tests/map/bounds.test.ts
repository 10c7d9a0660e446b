// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { bounds, knownBounds } from "../../src/map/bounds";
import { ellipseOf } from "../../src/model/ellipse";
import { emptyTeam, type Robot } from "../../src/model/model";

describe("an uncertainty ellipse", () => {
  it("is two standard deviations along the axes of an axis-parallel covariance", () => {
    const ellipse = ellipseOf({ variance_xx: 0.04, variance_xy: 0, variance_yy: 0.01 });
    expect(ellipse.major_m).toBeCloseTo(0.4, 9);
    expect(ellipse.minor_m).toBeCloseTo(0.2, 9);
    expect(ellipse.angle_rad).toBeCloseTo(0, 9);
  });
  it("turns with the covariance", () => {
    expect(ellipseOf({ variance_xx: 0.02, variance_xy: 0.01, variance_yy: 0.02 }).angle_rad).toBeCloseTo(Math.PI / 4, 9);
  });
});

it("shows the known floor without the unknown around it", () => {
  const data = new Int8Array(40).fill(-1);
  data.set([0, 0, 100], 13);
  const origin = { position: { x: -1, y: -2, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } };
  const stamp = { sec: 0, nsec: 0 };
  const grid = { header: { stamp, frame_id: "map" }, info: { map_load_time: stamp, resolution: 0.5, width: 10, height: 4, origin }, data };
  expect(knownBounds(grid)).toEqual({ left_m: 0.5, bottom_m: -1.5, width_m: 1.5, height_m: 0.5 });
  expect(knownBounds({ ...grid, data: data.fill(-1) })).toBeUndefined();
});

it("shows every robot whole", () => {
  const robot = { pose: { x_m: 2, y_m: -1, heading_rad: 0 } } as Robot;
  const { left_m, bottom_m, width_m, height_m } = bounds({ ...emptyTeam, robots: new Map([["io", robot]]) })!;
  expect(left_m).toBeLessThan(1.8);
  expect(bottom_m).toBeLessThan(-1.2);
  expect(left_m + width_m).toBeGreaterThan(2.2);
  expect(bottom_m + height_m).toBeGreaterThan(-0.8);
});
