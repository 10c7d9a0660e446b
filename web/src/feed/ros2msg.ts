// SPDX-License-Identifier: BSD-3-Clause
// Schemas in the encoding "ros2msg", as recordings have them: the text of a .msg file, and of those that it needs, each
// behind a line of = and one that names it ("MSG: geometry_msgs/Point").

export interface Field {
  readonly name: string;
  readonly type: string;
  readonly isComplex: boolean;
  readonly isArray?: true;
  readonly arrayLength?: number;
}

export interface Struct {
  readonly name: string;
  readonly definitions: Field[];
}

const PRIMITIVES = new Set(["bool", "uint8", "int8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64", "string"]);
const NUMBERS: Readonly<Record<string, string>> = { byte: "uint8", char: "uint8" };
/** Type, sizes in brackets, name; what may follow is a default, which no message lacks a value for. */
const FIELD = /^([\w/]+)(?:<=\d+)?(?:\[(<=)?(\d*)\])?\s+(\w+)(\s.*)?$/;
const CONSTANT = /^[\w/]+(?:<=\d+)?\s+\w+\s*=/;
/** What IDL calls nanosec the page calls nsec, in both encodings. */
const TIMES = new Set(["builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"]);

/** "geometry_msgs/msg/Point" for that and for "geometry_msgs/Point". */
const whole = (name: string): string => {
  const parts = name.split("/");
  return parts.length === 2 ? `${parts[0]}/msg/${parts[1]}` : name;
};

function typeOf(word: string, inside: string): Pick<Field, "type" | "isComplex"> {
  const type = NUMBERS[word] ?? word;
  if (PRIMITIVES.has(type)) return { type, isComplex: false };
  if (type === "Header") return { type: "std_msgs/msg/Header", isComplex: true };
  return { type: type.includes("/") ? whole(type) : `${inside.split("/")[0]}/msg/${type}`, isComplex: true };
}

function fieldOf(line: string, inside: string): Field {
  const [, word, bounded, length, name] = FIELD.exec(line) ?? [];
  if (!word || !name) throw new Error(`its schema has the line “${line}”, which defines no field`);
  return {
    name: TIMES.has(inside) && name === "nanosec" ? "nsec" : name,
    ...typeOf(word, inside),
    ...(length !== undefined && { isArray: true as const }),
    ...(length && !bounded && { arrayLength: Number(length) }),
  };
}

/** The message `type` first, and then those that it needs. */
export function parseRos2msg(type: string, text: string): Struct[] {
  const structs: Struct[] = [{ name: whole(type), definitions: [] }];
  for (const written of text.split("\n")) {
    const line = written.replace(/#.*/, "").trim();
    const begun = /^MSG:\s*(\S+)$/.exec(line)?.[1];
    const last = structs.at(-1)!;
    if (begun) structs.push({ name: whole(begun), definitions: [] });
    else if (line && !/^=+$/.test(line) && !CONSTANT.test(line)) last.definitions.push(fieldOf(line, last.name));
  }
  return structs;
}
