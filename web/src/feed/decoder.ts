// SPDX-License-Identifier: BSD-3-Clause
import { parseRos2idl } from "@foxglove/ros2idl-parser";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { parseRos2msg } from "./ros2msg";

export type Decode = (cdr: ArrayBufferView) => unknown;

/** A decoder of CDR (with its encapsulation header) for the type `name`, declared in `schema`: IDL, or as `encoding` says. */
export function decoderOf(name: string, schema: string, encoding = "ros2idl"): Decode {
  const definitions: ConstructorParameters<typeof MessageReader>[0] = encoding === "ros2msg" ? parseRos2msg(name, schema) : parseRos2idl(schema);
  const root = definitions.find((definition) => definition.name === name);
  if (!root) throw new Error(`the schema of ${name} does not declare it`);
  // The reader takes the first definition as the message's own.
  const reader = new MessageReader([root, ...definitions.filter((definition) => definition !== root)]);
  return (cdr) => reader.readMessage(cdr);
}
