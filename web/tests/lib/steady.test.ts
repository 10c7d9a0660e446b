// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { isAlike, steadyList } from "../../src/lib/steady";

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
