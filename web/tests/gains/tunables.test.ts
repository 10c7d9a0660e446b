// SPDX-License-Identifier: BSD-3-Clause
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { numberText, tunablesIn, withNumbers } from "../../src/gains/tunables";
import { catalog } from "../fixture/catalogs";

const programs = new URL("../../../bhdl/programs/", import.meta.url);
const office = ["office_cleanup.bhdl", "office_robot.bhdl"].map((path) => ({ path, text: readFileSync(new URL(path, programs), "utf8") }));
const program = (text: string) => [{ path: "a.bhdl", text }];
const combine = (gains: string) => program(`motor_schemas:\n  combine_forces: name: "search" inputs: "noise" "robot" gains: ${gains}\n  end\nend\n`);
const brief = (files: ReturnType<typeof program>) => tunablesIn(files, catalog).map(({ label, value, unit }) => `${label} ${value} ${unit}`.trim());

test("each gain belongs to its input, whatever stands between the numbers", () => {
  expect(brief(combine("1 2"))).toEqual(["gain of noise 1", "gain of robot 2"]);
  expect(brief(combine("1, ; of the noise 7\n  .5"))).toEqual(["gain of noise 1", "gain of robot 0.5"]);
});

test("a constant in a number's place has no slider, and leaves the others theirs", () => {
  expect(brief(combine("STRONG 2"))).toEqual(["gain of robot 2"]);
});

test("thresholds are in the unit that the text has, or else the catalog", () => {
  const text = 'perceptual_schemas: arrived: name: "near" locate_variable: "l" radius: 0.4 m end time_detector: name: "t" duration: 12 end end';
  expect(brief(program(text))).toEqual(["radius 0.4 m", "duration 12 s"]);
});

test("the shipped program's gains and thresholds have keys of their own and values within their ranges", () => {
  const all = tunablesIn(office, catalog);
  expect(all.length).toBeGreaterThan(40);
  expect(new Set(all.map(({ key }) => key)).size).toBe(all.length);
  for (const { key, value, min, max, step } of all) expect([key, min <= value && value <= max && min < max && step > 0]).toEqual([key, true]);
});

test("numbers are written in their places, and every other character stays", () => {
  const numbers = new Map(tunablesIn(office, catalog).filter(({ key }) => key.endsWith("search gains from_robot") || key.endsWith("trash_finder threshold 0")).map(({ key, value }) => [key, value * 2]));
  expect(numbers.size).toBe(2);
  const changed = withNumbers(office, catalog, numbers);
  expect(changed[0]).toEqual(office[0]);
  expect(changed[1]!.text).toBe(office[1]!.text.replace("threshold: 60  min_area: 8", "threshold: 120  min_area: 8").replace("gains: 1 2 1 1", "gains: 1 4 1 1"));
  expect(withNumbers(changed, catalog, new Map(tunablesIn(office, catalog).map(({ key, value }) => [key, value])))).toEqual(office);
});

test("a number has no more digits than its slider has steps", () => {
  expect([numberText(0.30000000000000004, 0.1), numberText(2, 0.01), numberText(61, 1), numberText(120, 50)]).toEqual(["0.3", "2", "61", "120"]);
});

test("are those that the terminal finds, with the same ranges", () => {
  const lines = tunablesIn(office, catalog).map(({ schema, label, value, unit, min, max, step }) => `${schema} · ${label} ${value} [${unit}] ${min} to ${max} by ${step}`);
  const told = readFileSync(new URL("../fixture/office_tunables.txt", import.meta.url), "utf8").trimEnd().split("\n");
  expect([...lines].sort()).toEqual([...told].sort());
});
