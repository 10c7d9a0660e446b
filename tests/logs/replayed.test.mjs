// SPDX-License-Identifier: BSD-3-Clause
// What `replay` makes of recordings that are not as our recorder writes them: in another order, in LZ4, with a
// message of a wild time, with a damaged chunk. Our recorder hears what comes.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, describe, test } from "node:test";
import {
  McapIndexedReader, McapWriter, MessageReader, MessageWriter, definitionsFor, domain, program, schemas, start, unzstd,
} from "./tools.mjs";

const START_NS = 1_700_000_000_000_000_000n;
const MS = 1_000_000n;
const folder = mkdtempSync(path.join(tmpdir(), "galilean-replayed-"));
const file = (name) => path.join(folder, name);
after(() => rmSync(folder, { recursive: true }));

const type = "galilean_msgs/msg/RobotState";
const { idl } = schemas().find((schema) => schema.ros_type === type);
const definitions = definitionsFor(type, idl);

class Parts {
  parts = [];
  async write(bytes) {
    this.parts.push(Buffer.from(bytes));
  }
  position = () => BigInt(this.parts.reduce((sum, part) => sum + part.length, 0));
}

/** An LZ4 frame whose one block is stored as it is, which the format allows. */
function storedAsLz4(bytes) {
  const size = Buffer.alloc(4);
  size.writeUInt32LE((bytes.length | 0x80000000) >>> 0);
  return Buffer.concat([Buffer.from([0x04, 0x22, 0x4d, 0x18, 0x60, 0x70, 0x73]), size, bytes, Buffer.alloc(4)]);
}

/** Writes a file with a chunk for each list of messages: their ticks, and their times behind the start in ms. */
async function write(name, chunks, { compression = "" } = {}) {
  const writable = new Parts();
  const compressChunk = compression && ((bytes) => ({ compression, compressedData: storedAsLz4(Buffer.from(bytes)) }));
  const writer = new McapWriter({ writable, chunkSize: 1, compressChunk: compressChunk || undefined });
  await writer.start({ profile: "ros2", library: "test" });
  const schemaId = await writer.registerSchema({ name: type, encoding: "ros2idl", data: Buffer.from(idl) });
  const channelId = await writer.registerChannel({ schemaId, topic: "/io/state", messageEncoding: "cdr", metadata: new Map() });
  const encoder = new MessageWriter(definitions);
  for (const [tick, at_ms] of chunks) {
    const logTime = at_ms === null ? 0n : START_NS + BigInt(at_ms) * MS;
    await writer.addMessage({ channelId, sequence: tick, logTime, publishTime: logTime, data: encoder.writeMessage({ robot: "io", tick: BigInt(tick) }) });
  }
  await writer.end();
  const bytes = Buffer.concat(writable.parts);
  writeFileSync(file(name), bytes);
  return bytes;
}

async function readerOf(bytes) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
  };
  const decompressHandlers = { zstd: (packed, size) => unzstd(packed, new Uint8Array(Number(size))) };
  return McapIndexedReader.Initialize({ readable, decompressHandlers });
}

/** Plays the file, and returns how that ended, with the ticks that were heard. */
async function play(name) {
  const heard = `heard-${name}`;
  const recorder = start(program("galilean-record"), ["--out", file(heard), "--domain", domain]);
  const replay = start(program("galilean-replay"), [file(name), "--domain", domain]);
  const { code } = await replay.ended;
  recorder.kill("SIGINT");
  await recorder.ended;
  const reader = await readerOf(readFileSync(file(heard)));
  const decoder = new MessageReader(definitions);
  const ticks = [];
  for await (const { data } of reader.readMessages()) ticks.push(Number(decoder.readMessage(data).tick));
  return { code, text: replay.text, ticks };
}

describe("a replay", () => {
  test("plays in the order of log time, and not in that of the file", async () => {
    await write("mixed.mcap", [[1, 0], [4, 300], [2, 100], [3, 200]]);
    const { code, text, ticks } = await play("mixed.mcap");
    assert.equal(code, 0, text);
    assert.deepEqual(ticks, [1, 2, 3, 4]);
  });

  test("reads LZ4", async () => {
    await write("lz4.mcap", [[1, 0], [2, 50], [3, 100]], { compression: "lz4" });
    const { code, text, ticks } = await play("lz4.mcap");
    assert.equal(code, 0, text);
    assert.deepEqual(ticks, [1, 2, 3]);
  });

  test("does not wait for decades after a message stamped 0, and says so", async () => {
    await write("zero.mcap", [[2, 0], [1, null], [3, 100]]);
    const { code, text, ticks } = await play("zero.mcap");
    assert.equal(code, 0, text);
    assert.deepEqual(ticks, [1, 2, 3]);
    assert.match(text, /silence: no message for 53\.9 years from 1970-01-01T00:00:00\.000Z to 2023-11-14T22:13:20\.000Z; a replay goes on at once\n/);
  });

  test("names the chunk that it leaves out, with its time, and ends with 3", async () => {
    const bytes = await write("damaged.mcap", [[1, 0], [2, 100], [3, 200]]);
    const [, second] = (await readerOf(bytes)).chunkIndexes;
    const at = Number(second.chunkStartOffset);
    bytes[at + 100] ^= 1;
    writeFileSync(file("damaged.mcap"), bytes);
    const { code, text, ticks } = await play("damaged.mcap");
    assert.equal(code, 3, text);
    assert.deepEqual(ticks, [1, 3]);
    const line = `damage: the chunk at byte ${at} does not match its checksum: 1 message from ` +
      "2023-11-14T22:13:20.100Z to 2023-11-14T22:13:20.100Z is lost (/io/state 1)\n";
    assert.ok(text.includes(line), text);
    assert.match(text, /played 2 messages/);
    assert.match(text, /galilean-replay: .*damaged\.mcap: 1 message is lost in all \(\/io\/state 1\)\n/);
  });
});
