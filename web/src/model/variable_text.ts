import { type Variable, VariableType } from "../feed/messages";
import { degrees, metres, signed } from "../lib/format";

const TYPE_NAMES = ["", "shaft", "image", "locate", "bits", "force"] as const;

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
    case VariableType.shaft:
      return `${signed(a, 2)}, ${metres(b)}  ${degrees(c)}  ${signed(d, 2)} m/s`;
    case VariableType.image:
      return `${a} × ${b} · frame ${c}`;
    case VariableType.locate:
      return `${signed(a, 2)}, ${metres(b)} ± ${metres(Math.sqrt(Math.max(c, e)))}`;
    case VariableType.bits:
      return bits(a);
    case VariableType.force:
      return `${Math.hypot(a, b).toFixed(2)} to ${degrees(Math.atan2(-a, b))}`;
    default:
      return [...values].join(", ");
  }
}
