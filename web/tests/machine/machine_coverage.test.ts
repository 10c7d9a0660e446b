// SPDX-License-Identifier: BSD-3-Clause
import { expect, test } from "vitest";
import type { Program } from "../../src/feed/messages";
import { coverageOf } from "../../src/machine/machine_coverage";
import { robotOf, state, T0_MS, told, transition } from "../model/told";

const condition = (from_state: string, to_state: string, bit_index = 0) => ({ from_state, to_state, bits_variable: "trash_seen", bit_index, bit_value: true });
const program = {
  hash: "aaaa", states: ["start", "wander", "grab"].map((name) => ({ name })),
  transitions: [condition("start", "wander"), condition("wander", "grab"), condition("wander", "grab", 1), condition("grab", "start")],
} as unknown as Program;
const change = (number: number, from_state: string, to_state: string) => ({ ...transition(number, to_state), from_state });
const heard = (...changes: ReturnType<typeof change>[]) =>
  told([["/io/state", state({ state: "wander", transitions: 9n }), T0_MS], ...changes.map((each): [string, unknown, number] => ["/io/transition", each, T0_MS])]);
const clock = new Date(T0_MS).toLocaleTimeString("en-GB");

test("conditions that lead the same way are one transition", () => {
  const { counts, sentence } = coverageOf(program, robotOf(heard(change(1, "start", "wander"), change(2, "wander", "grab"))));
  expect([...counts.arrows]).toEqual([["start → wander", 1], ["wander → grab", 1], ["grab → start", 0]]);
  expect(sentence).toBe(`3 of 3 states, 2 of 3 transitions, 2 of 4 conditions have happened since ${clock}, when this program began.`);
});

test("what is never entered is told apart from what was not seen to be entered", () => {
  const { counts, sentence } = coverageOf(program, robotOf(heard()));
  expect([...counts.states.values()]).toEqual([{ never: true, times: 0 }, { never: false, times: 0 }, { never: true, times: 0 }]);
  expect(sentence).toBe(`1 of 3 states, 0 of 3 transitions, 0 of 4 conditions have happened since ${clock}. What it did before is not known here.`);
});

test("a gap in what was heard is said", () => {
  expect(coverageOf(program, robotOf(heard(change(3, "start", "wander"), change(5, "grab", "start")))).sentence).toMatch(/ 1 change of state was not heard, so it may be more\.$/);
});

test("another program has its own coverage", () => {
  expect(coverageOf({ ...program, hash: "bbbb" }, robotOf(heard())).sentence).toBe("No change of state of this program has been heard yet.");
});
