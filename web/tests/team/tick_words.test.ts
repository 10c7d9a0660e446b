// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { isStrained, tickWords } from "../../src/team/tick_words";

const tick = { tick_time_us: 27.4, tick_time_max_us: 166, tick_period_s: 0.02, overruns: 0 };

it("says how long the last tick took, of what it has, and the longest lately", () => {
  expect(tickWords(tick)).toBe("last tick 27 µs of 20 ms, longest lately 166 µs");
});

it("is strained where a tick leaves less than half of its period, or one began late", () => {
  expect([tick, { ...tick, tick_time_max_us: 10_100 }, { ...tick, overruns: 1 }].map(isStrained)).toEqual([false, true, true]);
});
