// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { MachineTransition, Variable } from "../../src/feed/messages";
import { bitNow, conditionNow, nearnessOf, schemasOf, type Situation, triggersOf } from "../../src/machine/nearness";
import { catalog } from "../fixture/catalogs";
import { T0_MS, time } from "../model/told";

const TEXT = `perceptual_schemas:
  seen: name: "see" locate_variable: "trash" min_certainty: 0.5 bits_variable: "seen" end
  lost: name: "lose" locate_variable: "trash" min_certainty: 0.2 bits_variable: "lost" end
  arrived: name: "reach" locate_variable: "trash" radius: 22 bits_variable: "reached" bit_index: 1 end
  arrived: name: "reach_in_metres" locate_variable: "trash" radius: 0.5 m bits_variable: "near" end
  time_detector: name: "short" duration: 4 bits_variable: "up" end
  time_detector: name: "long" duration: 2 min bits_variable: "up" end
end`;
const triggers = triggersOf([{ path: "a.bhdl", text: TEXT }], catalog);
const variable = (name: string, type: Variable["type"], values: number[], certainty = 1, decay_per_s = 0): Variable =>
  ({ name, type, object_class: "", valid: certainty > 0, certainty, decay_per_s, updated: time(T0_MS), values: Float64Array.from(values) });
const condition = (bits_variable: string, bit_index = 0, bit_value = true): MachineTransition =>
  ({ from_state: "a", to_state: "b", file: "", line: 1, bits_variable, bit_index, bit_value, bit_update: "same", reset_variables: [] });
const now = (changes: Partial<Situation> = {}): Situation => ({
  variables: [variable("shaft", 1, [0, 0, 0, 0, 0]), variable("trash", 3, [0, 0.44, 0, 0, 0, 0.03], 0.6, 0.1)],
  age_ms: 0, in_state_s: 3, schemas: ["see", "lose", "reach", "reach_in_metres", "short"], ...changes,
});

describe("how near a condition is to firing", () => {
  it("is the share of a clock's time that has passed", () => {
    expect(nearnessOf(condition("up"), triggers, now())).toEqual({ share: 0.75, text: "in 1.0 s" });
  });
  it("says that a clock whose time has passed fires now", () => {
    expect(nearnessOf(condition("up"), triggers, now({ in_state_s: 1000 }))).toEqual({ share: 1, text: "fires now" });
  });
  it("counts only the trigger that the state runs", () => {
    expect(nearnessOf(condition("up"), triggers, now({ schemas: ["long"] }))?.share).toBeCloseTo(3 / 120);
    expect(nearnessOf(condition("up"), triggers, now({ schemas: [] }))).toBeUndefined();
  });
  it("is how far the robot has come, in the program's own units", () => {
    expect(nearnessOf(condition("reached", 1), triggers, now())).toEqual({ share: 0.5, text: "0.44 m away, fires at 0.22 m" });
    expect(nearnessOf(condition("near"), triggers, now())?.share).toBe(1);
  });
  it("is how much of a certainty is gone, and goes on while nothing is told", () => {
    const { share, text } = nearnessOf(condition("lost"), triggers, now({ age_ms: 2000 }))!;
    expect(share).toBeCloseTo(0.75);
    expect(text).toBe("sure 0.40, lost below 0.2, in 2.0 s unless it is seen again");
    expect(nearnessOf(condition("seen"), triggers, now({ age_ms: 2000 }))?.share).toBeCloseTo(0.8);
  });
  it("is measured from the variable that the trigger names, in both directions", () => {
    const [reach] = triggersOf([{ path: "a.bhdl", text: `perceptual_schemas:
  arrived: name: "reach" locate_variable: "trash" shaft_variable: "odometer" radius: 50 bits_variable: "reached" end
end` }], catalog);
    const variables = [variable("shaft", 1, [9, 9]), variable("odometer", 1, [1, 1]), variable("trash", 3, [1.6, 1.8])];
    expect(nearnessOf(condition("reached"), [reach!], now({ variables }))).toEqual({ share: 0.5, text: "1.00 m away, fires at 0.50 m" });
    const lost = [variable("odometer", 1, [1, 1], 0), variable("trash", 3, [1.6, 1.8])];
    expect(nearnessOf(condition("reached"), [reach!], now({ variables: lost }))).toEqual({ share: 0, text: "trash is not known" });
  });
  it("says what is not known, and what is sure for good", () => {
    const unknown = now({ variables: [variable("shaft", 1, [0, 0]), variable("trash", 3, [0, 0], 0)] });
    expect(nearnessOf(condition("reached", 1), triggers, unknown)).toEqual({ share: 0, text: "trash is not known" });
    expect(nearnessOf(condition("seen"), triggers, unknown)).toEqual({ share: 0, text: "trash is not known" });
    expect(nearnessOf(condition("lost"), triggers, unknown)).toEqual({ share: 1, text: "fires now: trash is not known" });
    const forGood = now({ variables: [variable("trash", 3, [0, 1], 0.6, 0)] });
    expect(nearnessOf(condition("lost"), triggers, forGood)?.text).toBe("sure 0.60, lost below 0.2");
  });
  it("says that it fires now where it does", () => {
    const near = now({ variables: [variable("shaft", 1, [0, 0, 0, 0, 0]), variable("trash", 3, [0, 0.1], 0.9, 0)] });
    expect(nearnessOf(condition("seen"), triggers, near)).toMatchObject({ share: 1, text: expect.stringMatching(/^fires now: sure 0.90, needs /) });
    expect(nearnessOf(condition("reached", 1), triggers, near)).toEqual({ share: 1, text: "fires now: 0.10 m away, fires at 0.22 m" });
  });
  it("takes a limit that the program does not give from the catalog", () => {
    const text = 'perceptual_schemas: arrived: name: "reach" locate_variable: "trash" bits_variable: "reached" end end';
    expect(triggersOf([{ path: "a.bhdl", text }], catalog)[0]).toMatchObject({ limit: 0.4, bit: 0, shaft: "shaft" });
  });
  it("is not known while the robot's catalog is not", () => {
    expect(triggersOf([{ path: "a.bhdl", text: TEXT }], undefined)).toEqual([]);
  });
  it("belongs to the bit, not only to its variable", () => {
    expect(nearnessOf(condition("reached", 0), triggers, now())).toBeUndefined();
  });
  it("is unknown of a bumper, and of a bit that is waited for at 0", () => {
    expect(nearnessOf(condition("bumpers"), triggers, now())).toBeUndefined();
    expect(nearnessOf(condition("up", 0, false), triggers, now())).toBeUndefined();
  });
});

describe("a condition's bit", () => {
  it("is read from its place, and is unknown while the variable is invalid", () => {
    const variables = [variable("gripper", 4, [2]), variable("stuck", 4, [1], 0)];
    expect([bitNow(condition("gripper", 1), variables), bitNow(condition("gripper"), variables)]).toEqual([true, false]);
    expect(bitNow(condition("stuck"), variables)).toBeUndefined();
  });
});

describe("a condition now", () => {
  it("is its bit and how near it is, of the schemas that the state runs", () => {
    const program = { states: [{ name: "a", perceptual_schemas: ["short"] }, { name: "b", perceptual_schemas: ["long"] }] } as never;
    expect(schemasOf(program, "b")).toEqual(["long"]);
    expect(schemasOf(program, "gone")).toEqual([]);
    const situation = now({ variables: [variable("up", 4, [1])], schemas: schemasOf(program, "a") });
    expect(conditionNow(condition("up"), triggers, situation)).toEqual({ bit: true, near: { share: 0.75, text: "in 1.0 s" } });
  });
});
