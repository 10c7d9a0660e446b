// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { clock, degrees, delay, lasting, metres, shortened, when } from "../../src/lib/format";

describe("numbers and times", () => {
  it("have units and a true minus", () => {
    expect(metres(-0.404)).toBe("−0.40 m");
    expect(metres(-0.001)).toBe("0.00 m");
    expect(degrees(Math.PI * 1.5)).toBe("−90°");
  });
  it("are a clock's where a contest runs out", () => {
    expect(clock(462.9)).toBe("07:42");
    expect(clock(-3)).toBe("00:00");
  });
  it("are relative when recent, clock when old", () => {
    const now = new Date(2024, 0, 1, 12, 3, 11).getTime();
    expect(when(now - 3000, now)).toBe("3 s ago");
    expect(when(now - 120_000, now)).toBe("12:01:11");
    expect(lasting(3.21)).toBe("3.2 s");
    expect(lasting(300)).toBe("5 min");
  });
});

it("shortens a long name in its middle", () => {
  expect(shortened("wander_for_trashcan", 11)).toBe("wande…shcan");
  expect(shortened("start", 11)).toBe("start");
});

it("says a delay in milliseconds below a second, else in seconds and more", () => {
  expect([85, 999, 1400, 20_830, 180_000].map(delay)).toEqual(["85 ms", "999 ms", "1.4 s", "21 s", "3 min"]);
});
