// SPDX-License-Identifier: BSD-3-Clause
// The project's own IDL: its text as it comes with each channel, and its files one by one.
import { readdirSync, readFileSync } from "node:fs";

export const IDL_FOLDER = new URL("../../core/wire/idl/", import.meta.url);

function withIncludes(file, seen = new Set()) {
  if (seen.has(file)) return "";
  seen.add(file);
  const text = readFileSync(new URL(file, IDL_FOLDER), "utf8");
  const included = text.replace(/^#include\s+"([^"]+)".*$/gm, (_, name) => withIncludes(name, seen));
  return included.replace(/^#.*$/gm, "");
}

/** The IDL text that declares a type such as "galilean_msgs/msg/RobotState". */
export function schemaOf(type) {
  return withIncludes(`${type.split("/")[0]}.idl`);
}

/** Of all files, such as "galilean_msgs". */
export function packages() {
  return readdirSync(IDL_FOLDER).filter((name) => name.endsWith(".idl")).map((name) => name.slice(0, -".idl".length)).sort();
}

/** One file as it stands. */
export function textOf(name) {
  return readFileSync(new URL(`${name}.idl`, IDL_FOLDER), "utf8");
}
