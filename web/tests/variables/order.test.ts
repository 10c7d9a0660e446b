// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { MachineTransition, Variable } from "../../src/feed/messages";
import type { Trigger } from "../../src/machine/nearness";
import { changedSince, inOrder, orderKey, orderOf, readIn } from "../../src/variables/order";

const variable = (name: string, type: number, values: number[] = [0], valid = true): Variable =>
  ({ name, type, object_class: "", valid, certainty: 1, decay_per_s: 0, updated: { sec: 0, nsec: 0 }, values: Float64Array.from(values) }) as Variable;
const way = (from_state: string, bits_variable: string, bit_index = 0) => ({ from_state, to_state: "b", bits_variable, bit_index }) as MachineTransition;
const trigger: Trigger = { measure: "certainty_at_least", schema: "seen", bits: "sees", bit: 0, locate: "trash", shaft: "", limit: 0.5 };

describe("the variables that conditions read", () => {
  it("are their bits and what sets them, of one state or of all", () => {
    const program = { transitions: [way("a", "sees"), way("b", "turned"), way("b", "sees", 3)] };
    expect([...readIn(program, [trigger], "a")]).toEqual(["sees", "trash"]);
    expect([...readIn(program, [trigger], "b")]).toEqual(["turned", "sees"]);
    expect([...readIn(program, [trigger])]).toEqual(["sees", "trash", "turned"]);
  });
});

describe("the order of the variables", () => {
  const items = [variable("camera", 2), variable("noise", 5), variable("shaft", 1, [1]), variable("turned", 4), variable("trash", 3), variable("sees", 4, [0], false)];
  it("begins with what the current state reads, and ends with frame numbers", () => {
    const order = orderOf(items, { readNow: new Set(["sees", "trash"]), readEver: new Set(["sees", "trash", "turned"]), changed: new Set(["shaft", "camera"]) });
    expect(order).toEqual(["trash", "sees", "turned", "shaft", "noise", "camera"]);
  });
  it("stays as it was found, with what is new at its end", () => {
    expect(inOrder(items, ["trash", "noise", "gone"]).map(({ name }) => name).slice(0, 3)).toEqual(["trash", "noise", "camera"]);
  });
  it("is found anew for another robot, and for a program that reads other variables, and not for other numbers", () => {
    const key = (limit: number, robot = "io", bits = "sees") => orderKey(robot, true, readIn({ transitions: [way("a", bits), way("b", "turned")] }, [{ ...trigger, limit }]));
    expect(key(0.5)).toBe(key(0.9));
    expect(new Set([key(0.5), key(0.5, "ganymede"), key(0.5, "io", "feels"), orderKey("io", false, new Set(["sees", "trash", "turned"]))]).size).toBe(4);
  });
  it("knows what has changed since an earlier sample", () => {
    const before = [variable("shaft", 1, [0]), variable("turned", 4), variable("sees", 4)];
    expect([...changedSince(before, items)]).toEqual(["shaft", "sees"]);
  });
});
