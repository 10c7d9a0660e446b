// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { missedBetween, withTransition } from "../../src/model/transitions";
import { T0_MS, transition } from "./told";

describe("the list of transitions", () => {
  const list = [transition(1, "a"), transition(2, "b")];
  const numbers = (all: readonly { number: bigint }[]) => all.map(({ number }) => Number(number));

  it("takes each once, however often it is told", () => {
    expect(withTransition(list, transition(2, "b"))).toBe(list);
  });
  it("puts a late one in its place", () => {
    expect(numbers(withTransition([...list, transition(4, "d")], transition(3, "c")))).toEqual([1, 2, 3, 4]);
  });
  it("tells how many were never heard", () => {
    expect(missedBetween(list[1]!, transition(6, "x"))).toBe(3);
    expect(missedBetween(list[0]!, list[1]!)).toBe(0);
  });
  it("begins anew when the robot does", () => {
    expect(numbers(withTransition(list, transition(1, "a", T0_MS + 60_000)))).toEqual([1]);
  });
});
