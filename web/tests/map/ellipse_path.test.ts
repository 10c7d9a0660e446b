// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { ellipsePath } from "../../src/map/ellipse_path";

const numbersOf = (path: string) => path.match(/-?\d+(\.\d+)?(e-?\d+)?/g)!.map(Number);

describe("an ellipse on the map", () => {
  it("begins at the end of its major axis, y down, and goes round by way of the other end", () => {
    const [x, y, major, minor, degrees, , , across_x, across_y] = numbersOf(ellipsePath({ major_m: 0.4, minor_m: 0.1, angle_rad: Math.PI / 6 }, 100));
    expect([major, minor]).toEqual([40, 10]);
    expect(degrees).toBeCloseTo(-30, 9);
    expect(x).toBeCloseTo(40 * Math.cos(Math.PI / 6), 9);
    expect(y).toBeCloseTo(-20, 9);
    expect([across_x, across_y]).toEqual([-x!, -y!]);
  });

  it("is a point where nothing is uncertain", () => {
    expect(numbersOf(ellipsePath({ major_m: 0, minor_m: 0, angle_rad: 0 }, 100)).every(Number.isFinite)).toBe(true);
  });
});
