// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { markWords, timeMarks, zoomed } from "../../src/model/time_span";

describe("a span of time", () => {
  it("keeps what the pointer is at where it is when it is zoomed", () => {
    const { from_ms, to_ms } = zoomed({ from_ms: 0, to_ms: 100_000 }, 0.5, 75_000);
    expect(to_ms - from_ms).toBe(50_000);
    expect((75_000 - from_ms) / (to_ms - from_ms)).toBeCloseTo(0.75);
  });
  it("grows neither shorter than bars say anything nor longer than is kept", () => {
    const lengths = [1e-6, 1e6].map((factor) => zoomed({ from_ms: 0, to_ms: 100_000 }, factor, 0)).map(({ from_ms, to_ms }) => to_ms - from_ms);
    expect(lengths).toEqual([5000, 1_800_000]);
  });
  it("is marked at round ages, and where it ends in the past at those that are seen", () => {
    const ages = (to_ms: number) => timeMarks({ from_ms: to_ms - 180_000, to_ms }, 1_000_000).map(({ ago_s }) => ago_s);
    expect(ages(1_000_000)).toEqual([0, 30, 60, 90, 120, 150, 180]);
    expect(ages(900_000)).toEqual([120, 150, 180, 210, 240, 270]);
  });
  it("gives no two marks the same words", () => {
    expect([0, 90, 120, 150, 180, 600].map(markWords)).toEqual(["now", "−90 s", "−2 min", "−2.5 min", "−3 min", "−10 min"]);
  });
});
