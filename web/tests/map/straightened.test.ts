// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { type Point, straightened } from "../../src/map/straightened";

const way = (count: number, at: (i: number) => [number, number]): Point[] => Array.from({ length: count }, (_, i) => ({ x: at(i)[0], y: at(i)[1] }));

/** How far a point is from a line between two others. */
function distance({ x, y }: Point, a: Point, b: Point): number {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const length2 = dx * dx + dy * dy;
  const along = length2 === 0 ? 0 : Math.min(Math.max(((x - a.x) * dx + (y - a.y) * dy) / length2, 0), 1);
  return Math.hypot(x - a.x - along * dx, y - a.y - along * dy);
}
const farthest = (points: readonly Point[], corners: readonly Point[]) =>
  Math.max(...points.map((point) => Math.min(...corners.slice(1).map((corner, i) => distance(point, corners[i]!, corner)))));

it("leaves the ends of a straight way, in any direction", () => {
  for (const angle of [0, 1, Math.PI, -3.1, 4]) {
    const points = way(200, (i) => [2.4 * i * Math.cos(angle), 2.4 * i * Math.sin(angle)]);
    expect(straightened(points, 0.5)).toEqual([points[0], points[199]]);
  }
});

it("keeps a corner, and how far a way goes that comes back on itself", () => {
  const corner = way(41, (i) => (i <= 20 ? [3 * i, 0] : [60, 3 * (i - 20)]));
  expect(straightened(corner, 0.5)).toEqual([corner[0], corner[20], corner[40]]);
  const back = way(41, (i) => (i <= 30 ? [3 * i, 0] : [90 - 3 * (i - 30), 0]));
  expect(straightened(back, 0.5)).toEqual([back[0], back[30], back[40]]);
});

it("stays within what is asked of every point of a curve, with far fewer corners", () => {
  const curve = way(500, (i) => [i * 2, 80 * Math.sin(i / 40) + 20 * Math.cos(i / 7)]);
  const corners = straightened(curve, 0.5);
  expect(farthest(curve, corners)).toBeLessThanOrEqual(0.51);
  expect(corners.length).toBeLessThan(250);
});

it("takes a way of few points, or of one place, as it is", () => {
  expect(straightened([], 0.5)).toEqual([]);
  expect(straightened(way(2, (i) => [i, i]), 0.5)).toHaveLength(2);
  expect(straightened(way(50, () => [7, 7]), 0.5)).toHaveLength(2);
});
