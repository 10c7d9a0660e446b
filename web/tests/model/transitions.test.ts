// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { groupedChanges, listedIn, missedBetween, withTransition } from "../../src/model/transitions";
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

describe("changes that repeat themselves", () => {
  const through = (states: readonly string[], first = 1) =>
    states.map((state, i) => ({ ...transition(first + i, state), from_state: states[i - 1] ?? "start" }));
  const round = (rounds: number) => Array.from({ length: rounds * 4 }, (_, i) => ["grab", "backup", "remember", "wander"][i % 4]!);
  const told = (list: ReturnType<typeof through>) => groupedChanges(list).map(({ states, rounds, changes }) => [states.join(" "), rounds, changes.length]);

  it("are put together and counted, the others stay alone", () => {
    expect(told(through(["wander", "avoid", "wander", ...round(14), "free"]))).toEqual([
      ["free", 1, 1], ["grab backup remember wander", 14, 56], ["wander", 1, 1], ["avoid", 1, 1], ["wander", 1, 1],
    ]);
  });
  it("are no group below three rounds", () => {
    expect(told(through(round(2)))).toHaveLength(8);
  });
  it("keep every change, the newest first", () => {
    const list = through(["free", ...round(5)]);
    expect(groupedChanges(list).flatMap(({ changes }) => changes)).toEqual([...list].reverse());
  });
  it("are not put together across changes that were not heard", () => {
    const list = [...through(round(2)), ...through(round(2), 20)];
    expect(groupedChanges(list).every(({ rounds }) => rounds === 1)).toBe(true);
  });
  it("may be more than are known, where the earliest is not the robot's first", () => {
    const cut = (list: ReturnType<typeof through>) => groupedChanges(list).map(({ isCut }) => isCut);
    const later = through(round(25), 300);
    expect(cut(later.slice(1))).toEqual([true]);
    expect(cut(later)).toEqual([false, false]);
    expect(cut(through(round(25)).slice(1).map((each) => ({ ...each, number: each.number - 1n })))).toEqual([false]);
  });
  it("are listed where their group is open, and the opened one in any case", () => {
    const [group] = groupedChanges(through(round(5)));
    const numbers = (...args: [boolean, bigint | undefined]) => listedIn(group!, ...args, 3).map(({ number }) => Number(number));
    expect(numbers(false, undefined)).toEqual([]);
    expect(numbers(false, 7n)).toEqual([7]);
    expect(numbers(true, 7n)).toEqual([20, 19, 18, 7]);
  });
  it("are none where there is no change", () => {
    expect(groupedChanges([])).toEqual([]);
  });
});
