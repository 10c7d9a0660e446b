// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { unwound, withPoint } from "../../src/model/trail";
import type { TrailPoint } from "../../src/model/model";

describe("a trail", () => {
  const at = (x_m: number, at_ms: number) => ({ x_m, y_m: 0, at_ms });
  it("takes no point where the robot stands still", () => {
    const trail = [at(1, 0)];
    expect(withPoint(trail, at(1.01, 100))).toBe(trail);
  });
  it("keeps a minute", () => {
    let trail: readonly TrailPoint[] = [];
    for (let second = 0; second <= 100; second += 1) trail = withPoint(trail, at(second, second * 1000));
    expect(trail[0]).toEqual(at(40, 40_000));
    expect(trail.at(-1)).toEqual(at(100, 100_000));
  });
});

it("counts a heading on past half a turn instead of spinning back", () => {
  const before = { x_m: 0, y_m: 0, heading_rad: 3.1 };
  expect(unwound(before, { x_m: 0, y_m: 0, heading_rad: -3.1 }).heading_rad).toBeCloseTo(2 * Math.PI - 3.1, 9);
});
