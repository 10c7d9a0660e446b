// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Transition } from "../../src/feed/messages";
import { type Coverage, conditionKey } from "../../src/model/coverage";
import { robotOf, state, T0_MS, told, transition } from "./told";

const change = (number: number, from_state: string, to_state: string, more: Partial<Transition> = {}): Transition => ({
  ...transition(number, to_state, T0_MS + number * 1000), from_state, ...more,
});
const heard = (...changes: Transition[]) => told(changes.map((each) => ["/io/transition", each, T0_MS + Number(each.number) * 1000]));
const coverage = (team = heard(), hash = "aaaa"): Coverage => robotOf(team).coverages!.get(hash)!;
const SWAP = { cause: "program swapped", bits_variable: "" };

describe("what has happened of a program", () => {
  it("is counted by state and by the condition that fired", () => {
    const { entered, fired } = coverage(heard(change(1, "start", "wander"), change(2, "wander", "grab"), change(3, "grab", "wander")));
    expect([...entered]).toEqual([["start", 0], ["wander", 2], ["grab", 1]]);
    expect(fired.get(conditionKey(change(3, "grab", "wander")))).toBe(1);
    expect(fired.get(conditionKey(change(3, "grab", "wander", { bit_index: 1 })))).toBeUndefined();
  });
  it("is counted once, however often it is told, and beyond what is kept of transitions", () => {
    const many = Array.from({ length: 300 }, (_, i) => change(i + 1, i % 2 ? "b" : "a", i % 2 ? "a" : "b"));
    const once = heard(...many);
    const again = told(many.slice(-64).map((each) => ["/io/transition", each, T0_MS + 400_000]), once);
    expect(coverage(again).entered.get("b")).toBe(150);
  });
  it("begins anew with another program, whose swap is no condition of its own", () => {
    const team = heard(change(1, "start", "wander"), change(2, "wander", "first", { ...SWAP, program_hash: "bbbb" }), change(3, "first", "second", { program_hash: "bbbb" }));
    expect(coverage(team, "bbbb")).toMatchObject({ fromStart: true, missed: 0 });
    expect([...coverage(team, "bbbb").entered]).toEqual([["first", 1], ["second", 1]]);
    expect(coverage(team, "bbbb").fired.size).toBe(1);
    expect(coverage(team).entered.get("wander")).toBe(1);
  });
});

describe("what cannot be known", () => {
  it("is what a page that was opened late did not hear", () => {
    expect(coverage(heard(change(7, "a", "b"))).fromStart).toBe(false);
    expect(coverage(told([["/io/state", state({ transitions: 4n }), T0_MS]])).fromStart).toBe(false);
    expect(coverage(told([["/io/state", state(), T0_MS]])).fromStart).toBe(true);
  });
  it("is what is missing between two changes, until it comes after all", () => {
    const gap = heard(change(1, "a", "b"), change(4, "c", "d"));
    expect(coverage(gap).missed).toBe(2);
    expect(coverage(told([["/io/transition", change(2, "b", "x"), T0_MS + 9000]], gap)).missed).toBe(1);
  });
  it("is when the state was entered in which the robot is first heard", () => {
    const team = told([["/io/state", state({ state: "grab", transitions: 4n, at_ms: T0_MS + 5000 }), T0_MS + 5000]]);
    expect([...coverage(team).entered]).toEqual([["grab", 0]]);
    const earlier = told([["/io/transition", change(3, "a", "b"), T0_MS + 5000]], team);
    expect(coverage(earlier).since.sec).toBe(T0_MS / 1000 + 3);
  });
  it("is forgotten where the robot's time goes back", () => {
    const team = told([["/io/state", state({ at_ms: T0_MS + 60_000 }), T0_MS]], heard(change(1, "start", "wander")));
    const back = told([["/io/state", state({ state: "x" }), T0_MS + 1000]], team);
    expect([...coverage(back).entered.keys()]).toEqual(["x"]);
  });
});
