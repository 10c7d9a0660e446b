// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { turnedPath } from "../../src/map/turned_path";

const rounded = (path: string) => path.replace(/-?\d+\.\d+(e-?\d+)?/g, (number) => String(Math.round(Number(number) * 100) / 100)).replace(/-0\b(?!\.)/g, "0").trim();

describe("an outline that is laid elsewhere", () => {
  it("is turned clockwise as it is seen, enlarged and moved", () => {
    expect(rounded(turnedPath("M0,-10 L8,5 Z", { angle_rad: Math.PI / 2, scale: 2, x: 100, y: 50 }))).toBe("M120,50 L90,66 Z");
  });
  it("keeps the flags of an arc, and enlarges its radii", () => {
    expect(rounded(turnedPath("M0,-9.5 A9.5,9.5 0 1 1 -0.01,-9.5 Z", { scale: 2 }))).toBe("M0,-19 A19,19 0 1 1 -0.02,-19 Z");
  });
  it("is the same where nothing is asked for", () => {
    expect(rounded(turnedPath("M-8,9 L-8,-4 L0,-10 Z", {}))).toBe("M-8,9 L-8,-4 L0,-10 Z");
  });
});
