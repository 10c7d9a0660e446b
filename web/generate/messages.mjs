// SPDX-License-Identifier: BSD-3-Clause
// Writes src/feed/messages.ts, the types of what the page hears, from core/wire/idl.
import { readFileSync, renameSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { commentsOf } from "./comments.mjs";
import { packages, schemaOf, textOf } from "./idl.mjs";
import { moduleOf } from "./typescript.mjs";

const TARGET = fileURLToPath(new URL("../src/feed/messages.ts", import.meta.url));

/** The module's text. */
export function messagesModule() {
  const files = packages().map((name) => ({ name, schema: schemaOf(name), text: textOf(name) }));
  const rules = commentsOf(textOf("galilean_msgs")).get("").split("\n").map((line) => `// ${line}\n`);
  return `// Made from core/wire/idl by generate/messages.mjs: change the IDL instead.\n//\n${rules.join("")}\n${moduleOf(files)}`;
}

function current() {
  try {
    return readFileSync(TARGET, "utf8");
  } catch {
    return undefined;
  }
}

/** Leaves a file that is right already as it is, and shows nobody one that is half written. */
export function writeMessages() {
  const text = messagesModule();
  if (text === current()) return;
  const unfinished = `${TARGET}.${process.pid}`;
  writeFileSync(unfinished, text);
  renameSync(unfinished, TARGET);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) writeMessages();
