// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Transition, Variable, Variables } from "../../src/feed/messages";
import { findings, valuesThen } from "../../src/model/moments";
import { robotOf, state, T0_MS, time, told, transition } from "./told";

function variable(name: string, value: number, valid = true): Variable {
  return { name, type: 4, object_class: "", valid, certainty: 1, decay_per_s: 0, updated: time(T0_MS), values: Float64Array.of(value) };
}
function variables(tick: number, ...items: Variable[]): Variables {
  return { stamp: time(T0_MS), robot: "io", tick: BigInt(tick), items };
}
const change = (changes: Partial<Transition>): Transition => ({ ...transition(1, "grab"), tick: 20n, ...changes });
const tested = (bits_variable: string, valid: boolean, holds: boolean) =>
  ({ to_state: "a", file: "f", line: 1, bits_variable, bit_index: 0, bit_value: true, valid, holds });

describe("what a robot knew when its state changed", () => {
  const heard = (...messages: [string, unknown][]) =>
    robotOf(told([["/io/state", state()], ...messages].map(([topic, message]) => [topic, message, T0_MS] as [string, unknown, number])));

  it("is told in whichever order the messages come", () => {
    const [early, late, later] = [variables(15, variable("a", 1)), variables(20, variable("a", 2)), variables(22, variable("a", 3))];
    const inOrder = heard(["/io/variables", early], ["/io/transition", change({})], ["/io/variables", late], ["/io/variables", later]);
    expect(inOrder.moments.get(1n)).toEqual({ before: early, after: late });
    const variablesFirst = heard(["/io/variables", early], ["/io/variables", late], ["/io/transition", change({})], ["/io/variables", later]);
    expect(variablesFirst.moments.get(1n)).toEqual({ after: late });
  });

  it("is of what was forgotten by it the value before", () => {
    const moment = { before: variables(15, variable("trash", 7)), after: variables(20, variable("trash", 0, false), variable("other", 1)) };
    const [trash, other] = valuesThen(moment, change({ reset_variables: ["trash"] }));
    expect(trash).toEqual({ variable: variable("trash", 7), forgotten: true });
    expect(other?.forgotten).toBe(false);
  });

  it("shows first what the conditions tested, and nothing invalid", () => {
    const moment = { after: variables(20, variable("a", 1), variable("b", 1), variable("c", 1, false)) };
    const names = valuesThen(moment, change({ tested: [tested("b", true, true)] })).map(({ variable: { name } }) => name);
    expect(names).toEqual(["b", "a"]);
  });
});

describe("findings", () => {
  it("tell the condition that fired from those that held as well, did not hold or could not", () => {
    const list = [tested("a", false, false), tested("b", true, false), tested("c", true, true), tested("d", true, true)];
    expect(findings(change({ tested: list }))).toEqual(["invalid", "did not hold", "fired", "held too"]);
  });
});
