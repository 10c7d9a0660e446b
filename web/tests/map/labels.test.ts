// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { type Label, placeLabels } from "../../src/map/labels";

const label = (key: string, x: number, y: number, more: Partial<Label> = {}): Label => ({ key, text: key, x, y, reach: 10, ...more });
const sidesOf = (...args: Parameters<typeof placeLabels>) => Object.fromEntries(placeLabels(...args));

describe("labels on the map", () => {
  it("stand to the right of their item where there is room", () => {
    expect(sidesOf([label("io", 0, 0), label("ganymede", 200, 0)])).toEqual({ io: "right", ganymede: "right" });
  });
  it("go to another side where another label stands", () => {
    expect(sidesOf([label("io", 0, 0), label("europa", 5, 4)])).toEqual({ io: "right", europa: "left" });
  });
  it("keep clear of a robot, but not of their own", () => {
    expect(sidesOf([label("io", 0, 0, { solid: true }), label("callisto", 25, 0, { solid: true })])).toEqual({ io: "left", callisto: "right" });
  });
  it("are left out where there is no room on any side", () => {
    const heap = Array.from({ length: 9 }, (_, i) => label(`robot${i}`, 0, 0));
    expect(Object.keys(sidesOf(heap))).toEqual(["robot0", "robot1", "robot2", "robot3"]);
  });
  it("are shown in any case where one must be, and others make room for it", () => {
    const heap = Array.from({ length: 9 }, (_, i) => label(`robot${i}`, 0, 0, { must: i === 8 }));
    expect(Object.keys(sidesOf(heap))).toEqual(["robot8", "robot0", "robot1", "robot2"]);
    const walled = [label("io", 0, 0, { must: true }), ...[[20, 0], [-20, 0], [0, 20], [0, -20]].map(([x, y], i) => label(`r${i}`, x!, y!, { solid: true, reach: 18 }))];
    expect(sidesOf(walled).io).toBe("right");
  });
  it("of trouble come before all names that stand already, and are never left out", () => {
    const can = label("can", 0, 0);
    expect(sidesOf([can, label("io silent 12 s", 0, 0, { urgent: true })], placeLabels([can]))).toEqual({ "io silent 12 s": "right", can: "left" });
    const walled = [label("io", 0, 0, { urgent: true }), ...[[20, 0], [-20, 0], [0, 20], [0, -20]].map(([x, y], i) => label(`r${i}`, x!, y!, { solid: true, reach: 18 }))];
    expect(sidesOf(walled).io).toBe("right");
  });
  it("are not cut at the edge of what is seen, where there is room on another side", () => {
    const room = { left: -20, right: 60, top: -100, bottom: 100 };
    expect(sidesOf([label("callisto", 40, 0)], new Map(), room)).toEqual({});
    expect(sidesOf([label("io", 50, 0)], new Map(), room)).toEqual({ io: "left" });
    expect(sidesOf([label("ganymede", 55, 0, { must: true })], new Map([["ganymede", "right"]]), room)).toEqual({ ganymede: "left" });
  });
  it("keep their side while it is free, though another would be free as well", () => {
    const crowded = [label("io", 0, 0), label("europa", 5, 4)];
    const before = placeLabels(crowded);
    expect(sidesOf([label("europa", 5, 4)], before)).toEqual({ europa: "left" });
  });
  it("are not driven out by one that had no place", () => {
    const before = placeLabels([label("europa", 5, 4)]);
    expect(sidesOf([label("io", 0, 0), label("europa", 5, 4)], before)).toEqual({ europa: "right", io: "left" });
  });
  it("are the same for the same items, and stay as they are", () => {
    const many = Array.from({ length: 30 }, (_, i) => label(`robot${i}`, (i * 37) % 150, (i * 23) % 90, { solid: true }));
    const first = placeLabels(many);
    expect(sidesOf(many)).toEqual(Object.fromEntries(first));
    expect(sidesOf(many, first)).toEqual(Object.fromEntries(first));
  });
});
