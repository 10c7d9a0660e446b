// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a variable, each with its name and unit, as the table shows them and plots draw them.

import { type Variable, Variable_Constants } from "../feed/messages";
import { degrees, inUnit, metres, signed, sureness } from "../lib/format";

export interface Quantity {
  readonly key: string;
  readonly unit: string;
  readonly text: string;
  readonly value: number;
}

type Read = (values: ArrayLike<number>) => Quantity[];

const at = (values: ArrayLike<number>, i: number): number => values[i] ?? 0;
const inMetres = (key: string, value: number): Quantity => ({ key, unit: "m", value, text: metres(value) });
const inDegrees = (key: string, value: number): Quantity => ({ key, unit: "°", value: (value * 180) / Math.PI, text: degrees(value) });
const bare = (key: string, value: number): Quantity => ({ key, unit: "", value, text: inUnit(value, "") });

const READERS: Readonly<Record<number, Read>> = {
  [Variable_Constants.SHAFT]: (v) => [
    inMetres("x", at(v, 0)),
    inMetres("y", at(v, 1)),
    inDegrees("heading", at(v, 2)),
    { key: "speed", unit: "m/s", value: at(v, 3), text: inUnit(at(v, 3), "m/s") },
    { key: "turn rate", unit: "°/s", value: (at(v, 4) * 180) / Math.PI, text: inUnit((at(v, 4) * 180) / Math.PI, "°/s") },
  ],
  [Variable_Constants.IMAGE]: (v) => [{ key: "frame", unit: "", value: at(v, 2), text: `frame ${at(v, 2)}` }],
  [Variable_Constants.LOCATE]: (v) => {
    const deviation_m = Math.sqrt(Math.max(at(v, 2), at(v, 4), 0));
    return [inMetres("x", at(v, 0)), inMetres("y", at(v, 1)), { key: "deviation", unit: "m", value: deviation_m, text: `± ${metres(deviation_m)}` }];
  },
  [Variable_Constants.BITS]: (v) => {
    const set = [...Array(32).keys()].filter((bit) => (Math.floor(at(v, 0) / 2 ** bit) & 1) === 1);
    return [{ key: "bits", unit: "", value: at(v, 0), text: set.length ? `${set.join(", ")} set` : "none set" }];
  },
  [Variable_Constants.FORCE]: (v) => [
    bare("length", Math.hypot(at(v, 0), at(v, 1))),
    inDegrees("angle", Math.atan2(-at(v, 0), at(v, 1))),
    bare("x", at(v, 0)),
    bare("y", at(v, 1)),
  ],
};

/** Empty where the type is unknown. Angles are counter-clockwise; of a force, from straight ahead. */
export function quantitiesOf({ type, values }: Variable): Quantity[] {
  return READERS[type]?.(values) ?? [];
}

export const CERTAINTY = "certainty";

/** One number of one robot's variable over time. */
export interface PlotLine {
  readonly robot: string;
  readonly variable: string;
  /** A quantity's key, or "certainty". */
  readonly quantity: string;
  readonly unit: string;
}

/** Those that count something. */
const WHOLE = new Set(["frame", "bits"]);

/** A value of a line, as the table shows it. */
export function lineText({ quantity, unit }: PlotLine, value: number): string {
  if (quantity === CERTAINTY) return sureness(value);
  return WHOLE.has(quantity) ? signed(value, 0) : inUnit(value, unit);
}

export function lineKey({ robot, variable, quantity }: PlotLine): string {
  return [robot, variable, quantity].join(" ");
}

/** The value of a line in a sample of its robot's variables; null where it is invalid: a gap. */
export function valueOf({ variable: name, quantity }: PlotLine, items: readonly Variable[]): number | null {
  const variable = items.find((each) => each.name === name);
  if (!variable) return null;
  if (quantity === CERTAINTY) return variable.valid ? variable.certainty : 0;
  if (!variable.valid) return null;
  return quantitiesOf(variable).find(({ key }) => key === quantity)?.value ?? null;
}
