// SPDX-License-Identifier: BSD-3-Clause
import { parseRos2idl } from "@foxglove/ros2idl-parser";
import { MessageReader } from "@foxglove/rosmsg2-serialization";

export type Decode = (cdr: ArrayBufferView) => unknown;

/** A decoder of CDR (with its encapsulation header) for the type `name`, declared in the IDL text `idl`. */
export function decoderOf(name: string, idl: string): Decode {
  const definitions = parseRos2idl(idl);
  const root = definitions.find((definition) => definition.name === name);
  if (!root) throw new Error(`the schema of ${name} does not declare it`);
  // The reader takes the first definition as the message's own.
  const reader = new MessageReader([root, ...definitions.filter((definition) => definition !== root)]);
  return (cdr) => reader.readMessage(cdr);
}
