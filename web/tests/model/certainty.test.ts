// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { certaintyAt, forgottenIn_s } from "../../src/model/certainty";

describe("certainty", () => {
  it("falls by its own rate between samples", () => {
    expect(certaintyAt(0.9, 1 / 60, 30_000)).toBeCloseTo(0.4, 9);
  });
  it("stops at nothing, and does not grow where clocks disagree", () => {
    expect(certaintyAt(0.5, 1 / 60, 60_000)).toBe(0);
    expect(certaintyAt(0.5, 1 / 60, -5000)).toBe(0.5);
  });
  it("is forgotten when it reaches nothing, and never where it does not decay", () => {
    expect(forgottenIn_s(0.5, 1 / 60)).toBeCloseTo(30, 9);
    expect(forgottenIn_s(1, 0)).toBeUndefined();
    expect(forgottenIn_s(0, 1 / 60)).toBeUndefined();
  });
});
