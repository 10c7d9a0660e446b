// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { keys, onKey } from "../../src/lib/keys";

it("has what was declared before, once what came over it is taken back, in whatever order", () => {
  const doneBy = () => keys.get("B")?.does;
  const taken = ["the page", "a panel", "a sheet"].map((does) => onKey("B", does, () => {}));
  expect(doneBy()).toBe("a sheet");
  taken[1]!();
  expect(doneBy()).toBe("a sheet");
  taken[2]!();
  expect(doneBy()).toBe("the page");
  taken[0]!();
  expect(doneBy()).toBeUndefined();
});
