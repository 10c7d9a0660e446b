// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { arrowPath, type Box, middleOf, pointOn } from "../../src/graph/machine_arrow";

const box = (x: number, y: number): Box => ({ x, y, width: 40, height: 20 });
const numbers = (path: string) => [...path.matchAll(/-?[\d.]+/g)].map(([text]) => Number(text));

/** Start, control point and end of a bent arrow. */
function pointsOf(path: string) {
  const [startX, startY, controlX, controlY, endX, endY] = numbers(path) as [number, number, number, number, number, number];
  return { start: { x: startX, y: startY }, control: { x: controlX, y: controlY }, end: { x: endX, y: endY } };
}

/** How far a point is from the nearest side of a box; 0 on its outline. */
function fromOutline({ x, y, width, height }: Box, point: { x: number; y: number }): number {
  const inside = point.x >= x - 0.06 && point.x <= x + width + 0.06 && point.y >= y - 0.06 && point.y <= y + height + 0.06;
  const sides = [point.x - x, x + width - point.x, point.y - y, y + height - point.y].map(Math.abs);
  return inside ? Math.min(...sides) : Number.POSITIVE_INFINITY;
}

describe("an arrow between two states", () => {
  const here = box(0, 0);
  it.each([["right", box(120, 0)], ["below", box(0, 90)], ["aslant", box(-150, -70)]])("leaves one box's outline and arrives at the other's: %s", (_, there) => {
    const { start, end } = pointsOf(arrowPath(here, there, [here, there]));
    expect(fromOutline(here, start)).toBeLessThan(0.1);
    expect(fromOutline(there, end)).toBeLessThan(0.1);
  });
  it("parts from the one that leads back", () => {
    const there = box(120, 0);
    const [forth, back] = [pointsOf(arrowPath(here, there, [])), pointsOf(arrowPath(there, here, []))];
    expect(forth.control).toEqual({ x: 80, y: 28 });
    expect(back.control).toEqual({ x: 80, y: -8 });
  });
  it("bends aside no further than a state between makes it, to the side with room", () => {
    const [there, between, below] = [box(200, 0), box(100, 0), box(100, 30)];
    const controlY = (all: Box[]) => pointsOf(arrowPath(here, there, all)).control.y - 10;
    expect(controlY([here, there])).toBe(18);
    expect(controlY([here, there, between])).toBe(52);
    expect(controlY([here, there, between, below])).toBe(-52);
  });
  it("crosses as little as it can where it cannot pass", () => {
    const there = box(200, 0);
    const wall: Box = { x: 90, y: -300, width: 20, height: 600 };
    // An arrow that bends further is longer, and has less of itself in the wall.
    expect(pointsOf(arrowPath(here, there, [here, there, wall])).control.y - 10).toBe(88);
  });
  it("loops at its right side where a state leads to itself", () => {
    const path = arrowPath(here, here, [here]);
    expect(path).toBe("M28.0,0.0 C32.0,-16.0 56.0,-4.0 40.0,10.0");
  });
});

describe("a point on an arrow", () => {
  it("is at that share of the way, on a bent arrow and on a loop", () => {
    const bent = "M0.0,0.0 Q10.0,20.0 20.0,0.0";
    expect(pointOn(bent, 0)).toEqual({ x: 0, y: 0 });
    expect(middleOf(bent)).toEqual({ x: 10, y: 10 });
    expect(pointOn(bent, 0.75)).toEqual({ x: 15, y: 7.5 });
    expect(middleOf("M0.0,0.0 C0.0,-8.0 8.0,-8.0 8.0,0.0")).toEqual({ x: 4, y: -6 });
  });
});
