// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { clock, dateAndTime, degrees, delay, fitted, inUnit, lasting, metres, preciseClock, shortened, size, sureness, when } from "../../src/lib/format";

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
  it("are told to the tenth of a second where one steps through them", () => {
    expect([preciseClock(12.3), preciseClock(0.0999), preciseClock(3661), preciseClock(-1)]).toEqual(["00:12.3", "00:00.0", "61:01.0", "00:00.0"]);
    expect(dateAndTime(new Date(2024, 10, 28, 12, 3, 11).getTime())).toBe("2024-11-28 12:03:11");
  });
  it("are as many bytes as somebody can imagine", () => {
    expect([0, 999, 1000, 12_400_000, 4.2e9].map(size)).toEqual(["0 B", "999 B", "1.0 kB", "12 MB", "4.2 GB"]);
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

it("leaves out no more of a name than it takes to fit", () => {
  const width = (text: string) => text.length * 7;
  expect(fitted("wander_for_trashcan", 77, width)).toBe("wande…shcan");
  expect(fitted("wander_for_trashcan", 133, width)).toBe("wander_for_trashcan");
  expect(fitted("wander", 3, width)).toBe("w…");
});

it("never says sixty of what is one of the next unit", () => {
  expect([9.94, 9.97, 119.4, 119.6].map(lasting)).toEqual(["9.9 s", "10 s", "119 s", "2 min"]);
});

it("writes a number the same wherever it stands", () => {
  expect([inUnit(-0.404, "m"), inUnit(1.2, "m/s"), inUnit(89.6, "°"), inUnit(-3.4, "°/s"), inUnit(1, "")]).toEqual(["−0.40 m", "1.20 m/s", "90°", "−3°/s", "1.00"]);
  expect(sureness(0.916)).toBe("0.92");
});

it("says a delay in milliseconds below a second, else in seconds and more", () => {
  expect([85, 999, 1400, 20_830, 180_000].map(delay)).toEqual(["85 ms", "999 ms", "1.4 s", "21 s", "3 min"]);
});
