// SPDX-License-Identifier: BSD-3-Clause
// The gains and thresholds of a program, each with the place of its number in the text. The terminal finds the same ones:
// monitor/top/gains/tunables.h.

import type { Tree } from "@lezer/common";
import type { AttributeSpec, Catalog, Role } from "../bhdl/catalog";
import { type AttributeText, type ComponentText, componentsOf } from "../bhdl/components";
import { parser } from "../bhdl/bhdl.grammar";
import type { SourceFile } from "../feed/messages";

const ROLES: readonly Role[] = ["gain", "threshold", "least_area", "certainty_at_least", "certainty_below", "distance_at_most", "time_at_least"];

export interface Tunable {
  /** The same as long as the program has this number, whatever its value. */
  readonly key: string;
  /** The schema's name. */
  readonly schema: string;
  readonly label: string;
  readonly unit: string;
  /** In the unit that the text writes it in. */
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly place: { readonly file: number; readonly from: number; readonly to: number };
}

interface WrittenNumber {
  readonly from: number;
  readonly to: number;
  readonly value: number;
  /** Empty where none is written. */
  readonly unit: string;
}

/** The values of an attribute in their order; undefined where a constant stands in a number's place. */
function numbersIn(text: string, tree: Tree, { from, to }: AttributeText): (WrittenNumber | undefined)[] {
  const numbers: (WrittenNumber | undefined)[] = [];
  tree.iterate({
    from,
    to,
    enter: ({ name, node }) => {
      if (node.from < from || node.to > to) return name !== "Comment";
      if (name === "Word" || name === "Text" || name === "Pair") numbers.push(undefined);
      if (name !== "Quantity") return name !== "Pair";
      const number = node.getChild("Number");
      const unit = node.getChild("Unit");
      const written = number && text.slice(number.from, number.to).replace(/^[–—−]/, "-");
      numbers.push(number ? { from: number.from, to: number.to, value: Number(written), unit: unit ? text.slice(unit.from, unit.to) : "" } : undefined);
      return false;
    },
  });
  return numbers;
}

const ROUND = [1, 2, 5, 10];

/** The next round number. */
function roundedUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1e-9)));
  return ROUND.find((round) => round * power >= value * (1 - 1e-9))! * power;
}

/** The catalog's own limits where they are of the size of the number, else as far as somebody would go. */
function rangeOf({ value, unit }: WrittenNumber, spec: AttributeSpec): Pick<Tunable, "min" | "max" | "step"> {
  const inItsUnit = unit === "" || unit === spec.unit;
  const least = inItsUnit ? (spec.minimum ?? 0) : 0;
  const far = Math.max(roundedUp(Math.abs(value) * 3), spec.type === "integer" ? 10 : 1);
  const most = inItsUnit ? (spec.maximum ?? far) : far;
  const max = Math.max(most <= 300 ? most : Math.min(most, far), value);
  const min = Math.min(least, value);
  return { min, max, step: spec.type === "integer" ? 1 : roundedUp((max - min) / 200) };
}

/** What each of an attribute's numbers belongs to, such as a gain's input. */
function namesOf(component: ComponentText, { of = "", one_for_each = "" }: AttributeSpec): string[] {
  const written = one_for_each && component.attributes.get(of)?.value;
  if (!written) return [];
  return written.includes('"') ? [...written.matchAll(/["“”„‟]([^"“”„‟]*)["“”„‟]/g)].map(([, name]) => name!) : [written];
}

function tunablesOf(component: ComponentText, spec: AttributeSpec, text: string, tree: Tree): Tunable[] {
  const attribute = component.attributes.get(spec.name);
  if (!attribute || !ROLES.some((role) => role === spec.role)) return [];
  const names = namesOf(component, spec);
  return numbersIn(text, tree, attribute).flatMap((number, i) => {
    if (!number || !Number.isFinite(number.value)) return [];
    const schema = component.name || component.type;
    const label = names[i] ? `gain of ${names[i]}` : spec.name;
    const key = `${component.type} ${schema} ${spec.name} ${names[i] ?? i}`;
    const place = { file: component.file, from: number.from, to: number.to };
    return [{ key, schema, label, unit: number.unit || (spec.unit ?? ""), value: number.value, ...rangeOf(number, spec), place }];
  });
}

/** In the order of the text. Numbers that stand in no text but in the catalog are left out, and constants are not followed. */
export function tunablesIn(files: readonly SourceFile[], catalog: Catalog): Tunable[] {
  const trees = files.map(({ text }) => parser.parse(text));
  const all = componentsOf(files).flatMap((component) => {
    const [text, tree] = [files[component.file]!.text, trees[component.file]!];
    return catalog.attributes(component.type).flatMap((spec) => tunablesOf(component, spec, text, tree));
  });
  const seen = new Map<string, number>();
  return all.map((tunable) => {
    const before = seen.get(tunable.key) ?? 0;
    seen.set(tunable.key, before + 1);
    return before === 0 ? tunable : { ...tunable, key: `${tunable.key} #${before + 1}` };
  });
}

/** As BHDL writes it: no more digits than its slider has steps. */
export function numberText(value: number, step: number): string {
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  return String(Number(value.toFixed(digits)));
}

/** With all its digits, and without the exponent that BHDL does not know. */
function exactText(value: number): string {
  const text = String(value);
  return text.includes("e") ? value.toFixed(20).replace(/0+$/, "") : text;
}

/**
 * The files with these numbers, by their tunables' keys, and every other character as it was; numbers that they lack are
 * left out. Numbers of a hand are rounded to their sliders' steps; `isExact`: they stood in the text before.
 */
export function withNumbers(files: readonly SourceFile[], catalog: Catalog, numbers: ReadonlyMap<string, number>, isExact = false): SourceFile[] {
  const changes = tunablesIn(files, catalog).filter(({ key, value }) => numbers.has(key) && numbers.get(key) !== value);
  changes.sort((a, b) => b.place.from - a.place.from);
  return files.map(({ path, text }, file) => {
    const mine = changes.filter(({ place }) => place.file === file);
    const textOf = ({ key, step }: Tunable) => (isExact ? exactText(numbers.get(key)!) : numberText(numbers.get(key)!, step));
    return { path, text: mine.reduce((all, each) => all.slice(0, each.place.from) + textOf(each) + all.slice(each.place.to), text) };
  });
}
