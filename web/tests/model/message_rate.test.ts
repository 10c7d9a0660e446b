// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { type MessageRate, withMessages } from "../../src/model/message_rate";

const after = (times_ms: number[]): MessageRate => times_ms.reduce<MessageRate | undefined>((rate, at_ms) => withMessages(rate, at_ms), undefined)!;

describe("the rate of a robot's messages", () => {
  it("is known once a window of two seconds is full", () => {
    const every100ms = Array.from({ length: 20 }, (_, i) => i * 100);
    expect(after(every100ms)).toEqual({ from_ms: 0, count: 20 });
    expect(after([...every100ms, 2000])).toEqual({ from_ms: 2000, count: 1, per_s: 10 });
  });
  it("stays while the next window fills, and follows when messages become rare", () => {
    const busy = Array.from({ length: 21 }, (_, i) => i * 100);
    expect(after([...busy, 2100, 2200])).toEqual({ from_ms: 2000, count: 3, per_s: 10 });
    expect(after([...busy, 3000, 4000]).per_s).toBe(1);
  });
  it("counts what a page that was busy took in as one", () => {
    const rate = withMessages(withMessages(withMessages(undefined, 0), 1000, 10), 2000, 10);
    expect(rate).toEqual({ from_ms: 2000, count: 10, per_s: 5.5 });
  });
  it("begins anew where time goes back, as when a recording is wound", () => {
    expect(after([5000, 5100, 100])).toEqual({ from_ms: 100, count: 1 });
  });
});
