// SPDX-License-Identifier: BSD-3-Clause
// What the log and wire tests share: where the programs are, and the reference decoders.
import assert from "node:assert/strict";
import { execFileSync, spawn, spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { freshDomain } from "../tools/domain.mjs";
import { PATIENCE_MS, within } from "../tools/patience.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const require = createRequire(path.join(here, "../node/package.json"));

const { parse: parseMsg } = require("@foxglove/rosmsg");
export const { parseRos2idl } = require("@foxglove/ros2idl-parser");
export const { MessageReader, MessageWriter } = require("@foxglove/rosmsg2-serialization");
export const { McapChunkBuilder, McapIndexedReader, McapRecordBuilder, McapStreamReader, McapWriter } = require("@mcap/core");
export const { decompress: unzstd } = require("fzstd");

const build = process.env.GALILEAN_BUILD ?? path.join(here, "../../build");
export const program = (name) => path.join(build, "bin", name);
export const testTool = (name) => path.join(build, "tests", name);

// A domain of our own, so that tests hear nobody else.
export const domain = freshDomain();
/** For programs that are run to their end. */
export const limit = { timeout: PATIENCE_MS };

let schemaList;
export function schemas() {
  schemaList ??= JSON.parse(
    execFileSync(testTool("wire_echo"), ["--schemas"], { maxBuffer: 1 << 26, ...limit }).toString(),
  );
  return schemaList;
}

// The definitions that a reader of `rosType` takes: its own first, under no name.
export function definitionsFor(rosType, idl) {
  const all = parseRos2idl(idl);
  const own = all.find((definition) => definition.name === rosType);
  if (!own) throw new Error(`${rosType} is not in its own schema`);
  return [{ ...own, name: undefined }, ...all.filter((definition) => definition !== own)];
}

/** The definitions for a reader of the messages of a schema as MCAP's reference reader gives it. */
export function definitionsOf({ name, encoding, data }) {
  const text = new TextDecoder().decode(data);
  return encoding === "ros2msg" ? parseMsg(text, { ros2: true }) : definitionsFor(name, text);
}

const readable = (bytes) => ({
  size: async () => BigInt(bytes.length),
  read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
});
export const decompressHandlers = { zstd: (bytes, size) => unzstd(bytes, new Uint8Array(Number(size))) };

/** A recording as MCAP's reference reader reads it, with all its messages, of which each knows its topic. */
export async function readIndexed(file) {
  const reader = await McapIndexedReader.Initialize({ readable: readable(readFileSync(file)), decompressHandlers });
  const messages = [];
  for await (const message of reader.readMessages({ validateCrcs: true }))
    messages.push({ ...message, topic: reader.channelsById.get(message.channelId).topic });
  return { reader, messages };
}

/** What `log info` says. Its exit code must be this one, or what is told to be missing. */
export function info(file, status) {
  const ended = spawnSync(program("galilean-log"), ["info", file, "--json"], limit);
  const text = ended.stdout.toString();
  assert.notEqual(text, "", ended.stderr.toString());
  const told = JSON.parse(text);
  const isMissing = told.recovered || told.losses?.missing > 0 || told.losses?.copies.length > 0;
  assert.equal(ended.status, status ?? (isMissing ? 3 : 0), `${ended.stderr}${text}`);
  return told;
}

export function start(command, args, options = {}) {
  const child = spawn(command, args, options);
  child.text = "";
  child.stdout?.on("data", (data) => (child.text += data));
  child.stderr?.on("data", (data) => (child.text += data));
  const closed = new Promise((resolve) => child.on("close", (code, signal) => resolve({ code, signal })));
  /** How it ended, once it has. */
  Object.defineProperty(child, "ended", { get: () => within(closed, () => `the end of ${command} ${args.join(" ")}, which said:\n${child.text}`) });
  return child;
}

/** Waits for the end of a recorder. It must end well: with 3 if it says that messages were lost, as on a busy machine. */
export async function endsWell(recorder) {
  const { code } = await recorder.ended;
  assert.equal(code, / lost \d+ of /.test(recorder.text) ? 3 : 0, recorder.text);
}
