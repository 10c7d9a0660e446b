// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { isAlike, steadyItems, steadyList, steadySet } from "../../src/lib/steady";

it("a list stays the same one while its items do", () => {
  const keep = steadyList<number>();
  const first = keep([1, 2]);
  expect(keep([1, 2])).toBe(first);
  expect(keep([1, 3])).toEqual([1, 3]);
  expect(keep([1])).toEqual([1]);
  expect(keep([])).toEqual([]);
});

it("items may be the same by what they say", () => {
  const keep = steadyList<{ key: string; x?: number }>(isAlike);
  const first = keep([{ key: "io", x: 1 }]);
  expect(keep([{ key: "io", x: 1 }])).toBe(first);
  expect(keep([{ key: "io", x: 2 }])).toEqual([{ key: "io", x: 2 }]);
  expect(keep([{ key: "io" }])).toEqual([{ key: "io" }]);
});

it("a set stays the same one while its members do, in whatever order", () => {
  const keep = steadySet<string>();
  const first = keep(new Set(["io", "callisto"]));
  expect(keep(new Set(["callisto", "io"]))).toBe(first);
  expect([...keep(new Set(["io"]))]).toEqual(["io"]);
  expect(keep(new Set()).size).toBe(0);
});

it("each item stays the same one while it says the same, wherever it stands", () => {
  const keep = steadyItems<{ name: string; x: number }>(({ name }) => name);
  const [io, callisto] = keep([{ name: "io", x: 1 }, { name: "callisto", x: 1 }]);
  const [next, moved] = keep([{ name: "callisto", x: 1 }, { name: "io", x: 2 }]);
  expect(next).toBe(callisto);
  expect([moved === io, moved]).toEqual([false, { name: "io", x: 2 }]);
});
