// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Variable } from "../../src/feed/messages";
import { lineText, quantitiesOf, valueOf } from "../../src/plots/quantities";
import { Samples } from "../../src/plots/samples";
import { isShown, kindsOf } from "../../src/variables/variable_filter";
import { T0_MS, time } from "../model/told";

const variable = (name: string, type: Variable["type"], values: number[], changes: Partial<Variable> = {}): Variable =>
  ({ name, type, object_class: "", valid: true, certainty: 0.5, decay_per_s: 0.1, updated: time(T0_MS), values: Float64Array.from(values), ...changes });

describe("the numbers of a variable", () => {
  it("have units, and angles are counter-clockwise from straight ahead", () => {
    const texts = quantitiesOf(variable("to_trash", 5, [-1, 0])).map(({ key, text }) => [key, text]);
    expect(texts.slice(0, 2)).toEqual([["length", "1.00"], ["angle", "90°"]]);
    expect(quantitiesOf(variable("trash", 3, [1, 2, 0.04, 0, 0.01, 0])).map(({ text }) => text)).toEqual(["1.00 m", "2.00 m", "± 0.20 m"]);
  });
  it("read the same in a plot's legend as in the table", () => {
    for (const [type, values] of [[1, [1.234, 2, 3, 0.25, -0.5]], [2, [640, 480, 17]], [5, [-1, 0.5]]] as const)
      for (const { key: quantity, unit, value, text } of quantitiesOf(variable("v", type, [...values])))
        expect([quantity, lineText({ robot: "io", variable: "v", quantity, unit }, value)]).toEqual([quantity, text.replace("frame ", "")]);
  });
  it("leave a gap in a plot where the variable is invalid, but its certainty is 0 then", () => {
    const invalid = [variable("trash", 3, [1, 2, 0, 0, 0, 0], { valid: false })];
    const line = { robot: "io", variable: "trash", unit: "m" };
    expect(valueOf({ ...line, quantity: "x" }, invalid)).toBeNull();
    expect(valueOf({ ...line, quantity: "certainty" }, invalid)).toBe(0);
    expect(valueOf({ ...line, quantity: "x" }, [])).toBeNull();
  });
});

describe("samples", () => {
  it("are bounded, in order, and found by their time", () => {
    const samples = new Samples(10);
    for (let i = 0; i < 100; i += 1) samples.add(i * 1000, i);
    samples.add(5000, 5);
    expect(samples.times_s.length).toBeLessThanOrEqual(12);
    expect(samples.values.at(-1)).toBe(99);
    expect([samples.at(98_500), samples.at(0)]).toEqual([98, undefined]);
  });
});

describe("the filter of the table", () => {
  const trash = variable("trash", 3, [], { object_class: "trash" });
  it("finds by parts of name, type and class, all of them", () => {
    expect([isShown(trash, "tra", "all", 0), isShown(trash, "LOCATE ras", "all", 0), isShown(trash, "tra bits", "all", 0)]).toEqual([true, true, false]);
  });
  it("shows one type, or what is still valid", () => {
    expect([isShown(trash, "", "bits", 0), isShown(trash, "", "locate", 0)]).toEqual([false, true]);
    expect([isShown(trash, "", "valid", 4000), isShown(trash, "", "valid", 6000)]).toEqual([true, false]);
    expect(kindsOf([trash])).toEqual(["all", "valid", "locate"]);
  });
});

describe("the samples of a line", () => {
  const samples = new Samples();
  for (let s = 0; s < 10; s += 1) samples.add(T0_MS + s * 1000, s);

  it("forget what is newer where a recording goes back, and are not joined across what nobody heard", () => {
    samples.goOnFrom(T0_MS + 4500);
    expect([samples.at(T0_MS + 4400), samples.at(T0_MS + 4600)]).toEqual([4, null]);
    samples.add(T0_MS + 5000, 50);
    expect(samples.values).toEqual([0, 1, 2, 3, 4, null, 50]);
    samples.goOnFrom(T0_MS + 60_000);
    expect([samples.at(T0_MS + 50_000), samples.at(T0_MS + 60_000)]).toEqual([50, null]);
  });
});
