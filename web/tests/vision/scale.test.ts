// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { scaleLines } from "../../src/vision/scale";

const VIEW_RAD = (73.5 * Math.PI) / 180;

it("puts ranges where the robot's camera model sees the floor", () => {
  const lines = scaleLines({ height_m: 0.2, forward_m: 0.1 }, VIEW_RAD, 352, 186);
  // fx = 176 / tan(36.75°) = 235.68; fy = fx · 186 / 264 = 166.05; row = 93 + 0.2 · fy / depth
  expect(lines.map(({ depth_m, row_px }) => [depth_m, Number(row_px.toFixed(1))])).toEqual([
    [undefined, 93],
    [2, 109.6],
    [1, 126.2],
    [0.5, 159.4],
  ]);
});

it("leaves out what lies below the picture", () => {
  expect(scaleLines({ height_m: 0.5, forward_m: 0 }, VIEW_RAD, 352, 186).map(({ depth_m }) => depth_m)).toEqual([undefined, 4, 2, 1]);
});
