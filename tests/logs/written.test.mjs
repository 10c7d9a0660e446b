// SPDX-License-Identifier: BSD-3-Clause
// What `galilean log convert`, `slice` and `merge` write is read by MCAP's own reference reader: messages, metadata and
// attachments, each with its checksum.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { McapIndexedReader, McapWriter, limit, program, unzstd } from "./tools.mjs";

const SECOND_NS = 1_000_000_000n;
const START_NS = 1_700_000_000n * SECOND_NS;
const folder = mkdtempSync(path.join(tmpdir(), "galilean-written-"));
const file = (name) => path.join(folder, name);
after(() => rmSync(folder, { recursive: true }));

class Parts {
  parts = [];
  async write(bytes) {
    this.parts.push(Buffer.from(bytes));
  }
  position = () => BigInt(this.parts.reduce((sum, part) => sum + part.length, 0));
}

/** Ten seconds of two topics, of which one is out of order, with metadata and an attachment. */
async function write(name) {
  const writable = new Parts();
  const writer = new McapWriter({ writable, chunkSize: 100 });
  await writer.start({ profile: "ros2", library: "test" });
  await writer.addMetadata({ name: "who", metadata: new Map([["robot", "io"]]) });
  await writer.addAttachment({ name: "a.bhdl", mediaType: "text/plain", logTime: 5n, createTime: 4n, data: Buffer.from("state:\n") });
  const schemaId = await writer.registerSchema({ name: "a_msgs/msg/Level", encoding: "ros2msg", data: Buffer.from("float64 level_m\n") });
  const channels = [];
  for (const topic of ["/a", "/b"]) channels.push(await writer.registerChannel({ schemaId, topic, messageEncoding: "cdr", metadata: new Map([["k", topic]]) }));
  for (let i = 0; i < 100; ++i) {
    const data = Buffer.alloc(12);
    data[1] = 1;
    data.writeDoubleLE(i / 10, 4);
    const at = BigInt(i % 2 ? i : 98 - i) * (SECOND_NS / 10n);
    await writer.addMessage({ channelId: channels[i % 2], sequence: i + 1, logTime: START_NS + at, publishTime: START_NS + at - 7n, data });
  }
  await writer.end();
  writeFileSync(file(name), Buffer.concat(writable.parts));
}

/** What the reference reader finds in a file, in the order of log times. */
async function contentsOf(name) {
  const bytes = readFileSync(file(name));
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
  };
  const decompressHandlers = { zstd: (packed, size) => unzstd(packed, new Uint8Array(Number(size))) };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const found = { messages: [], metadata: [], attachments: [] };
  for await (const { channelId, sequence, logTime, publishTime, data } of reader.readMessages({ validateCrcs: true })) {
    const { topic, metadata } = reader.channelsById.get(channelId);
    found.messages.push({ topic, metadata: Object.fromEntries(metadata), sequence, logTime, publishTime, data: Buffer.from(data).toString("hex") });
  }
  found.messages.sort((a, b) => Number(a.logTime - b.logTime) || a.topic.localeCompare(b.topic));
  for await (const { name: called, metadata } of reader.readMetadata()) found.metadata.push([called, Object.fromEntries(metadata)]);
  for await (const { name: called, mediaType, logTime, createTime, data } of reader.readAttachments({ validateCrcs: true }))
    found.attachments.push([called, mediaType, logTime, createTime, Buffer.from(data).toString()]);
  return found;
}

function log(...words) {
  const { status, stdout, stderr } = spawnSync(program("galilean-log"), words, { ...limit, encoding: "utf8" });
  assert.equal(status, 0, `${words.join(" ")}: ${stdout}${stderr}`);
  return stdout;
}

describe("a written recording", () => {
  before(() => write("run.mcap"));

  for (const compression of ["zstd", "none"])
    test(`converted to ${compression} holds all that the first one does`, async () => {
      log("convert", file("run.mcap"), "--compression", compression, "--chunk-kb", "1", "--out", file(`${compression}.mcap`));
      assert.deepEqual(await contentsOf(`${compression}.mcap`), await contentsOf("run.mcap"));
      log("verify", file(`${compression}.mcap`));
    });

  test("in LZ4 is whole, and equals the first one", () => {
    log("convert", file("run.mcap"), "--compression", "lz4", "--out", file("lz4.mcap"));
    assert.match(log("info", file("lz4.mcap")), /compression lz4\n/);
    assert.equal(log("diff", file("run.mcap"), file("lz4.mcap")), "no difference\n");
  });

  test("of parts that are merged holds all that the whole does", async () => {
    log("slice", file("run.mcap"), "--to", "4.95s", "--out", file("early.mcap"));
    log("slice", file("run.mcap"), "--from", "4.95s", "--out", file("late.mcap"));
    log("merge", file("late.mcap"), file("early.mcap"), "--out", file("merged.mcap"));
    const [merged, whole] = [await contentsOf("merged.mcap"), await contentsOf("run.mcap")];
    assert.deepEqual(merged, whole);
    assert.ok((await contentsOf("early.mcap")).messages.length < whole.messages.length);
  });

  test("that reaches the limit of a file's size says so", () => {
    const { status, stderr } = spawnSync("bash", ["-c", 'ulimit -f 1; exec "$@"', "bash", program("galilean-log"), "convert", file("run.mcap"), "--compression", "none", "--out", file("limited.mcap")], { ...limit, encoding: "utf8" });
    assert.equal(status, 1, stderr);
    assert.match(stderr, /limited\.mcap cannot be written: File too large, by the limit that 'ulimit -f' shows; [^\n]*\n$/);
  });

  test("is printed in the order of log times, with the fields of its own schema", () => {
    const lines = log("cat", file("run.mcap"), "--json").trimEnd().split("\n").map((line) => JSON.parse(line));
    assert.equal(lines.length, 100);
    const times = lines.map(({ at_s }) => at_s);
    assert.deepEqual(times, [...times].sort((a, b) => a - b));
    assert.deepEqual(lines[0], { at_s: 0, log_ns: String(START_NS), publish_ns: String(START_NS - 7n), topic: "/a", sequence: 99, message: { level_m: 9.8 } });
  });
});
