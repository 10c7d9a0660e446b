// SPDX-License-Identifier: BSD-3-Clause
import { type Variable, Variable_Constants } from "../feed/messages";
import { namesOf } from "../feed/parts";
import { degrees, metres, signed } from "../lib/format";

const TYPE_NAMES = namesOf(Variable_Constants);

/** The word for a type of variable, as programs and catalogs have it. */
export const typeWord = (type: number): string => TYPE_NAMES[type] ?? "unknown";

export function typeName(variable: Variable): string {
  const name = typeWord(variable.type);
  return variable.object_class ? `${name} · ${variable.object_class}` : name;
}

function bits(value: number): string {
  const set = [...Array(32).keys()].filter((bit) => (Math.floor(value / 2 ** bit) & 1) === 1);
  return set.length ? `${set.join(", ")} set` : "none set";
}

/** The value in words with units, no finer than it is good for; empty for an invalid variable. */
export function valueText({ type, valid, values }: Variable): string {
  const [a = 0, b = 0, c = 0, d = 0, e = 0] = values;
  if (!valid) return "";
  switch (type) {
    case Variable_Constants.SHAFT:
      return `${signed(a, 2)}, ${metres(b)}  ${degrees(c)}  ${signed(d, 2)} m/s`;
    case Variable_Constants.IMAGE:
      return `${a} × ${b} · frame ${c}`;
    case Variable_Constants.LOCATE:
      return `${signed(a, 2)}, ${metres(b)} ± ${metres(Math.sqrt(Math.max(c, e)))}`;
    case Variable_Constants.BITS:
      return bits(a);
    case Variable_Constants.FORCE:
      return `${Math.hypot(a, b).toFixed(2)} to ${degrees(Math.atan2(-a, b))}`;
    default:
      return [...values].join(", ");
  }
}
