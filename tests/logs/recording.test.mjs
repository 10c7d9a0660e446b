// SPDX-License-Identifier: BSD-3-Clause
// What galilean-record writes, read by MCAP's own reference reader; and what is left of a recording
// when things break.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { crc32 } from "./crc32.mjs";
import {
  McapStreamReader, MessageReader, decompressHandlers, definitionsOf, domain, endsWell, info, limit, program, readIndexed, start, testTool,
} from "./tools.mjs";

function readStream(file) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append(new Uint8Array(readFileSync(file)));
  const records = [];
  for (let record; (record = reader.nextRecord()); ) records.push(record);
  return records;
}

/** A record's opcode and length, and the one number in it. */
const DATA_END_BYTES = 1 + 8 + 4;
/** Behind a chunk's opcode, length, two times and uncompressed size. */
const CHUNK_CRC_AT = 1 + 8 + 8 + 8 + 8;

describe("a recording", () => {
  const folder = mkdtempSync(path.join(tmpdir(), "galilean-logs-"));
  const file = (name) => path.join(folder, name);
  let talker;

  const record = (name, ...options) =>
    start(program("galilean-record"), ["--out", file(name), "--domain", domain, ...options]);
  const grown = async (name, size) => {
    for (let i = 0; i < 1000; ++i) {
      try {
        if (statSync(file(name)).size > size) return;
      } catch {
        // not there yet
      }
      await sleep(10);
    }
    assert.fail(`${name} did not grow to ${size} bytes`);
  };

  before(() => (talker = start(testTool("wire_talker"), ["io", domain])));
  after(async () => {
    talker.stdin.end();
    await talker.ended;
    rmSync(folder, { recursive: true });
  });

  test("is read whole by the reference reader, with checksums, and decodes to what was said", async () => {
    const recorder = record("whole.mcap", "--duration", "3");
    await endsWell(recorder);
    assert.match(recorder.text, /whole\.mcap: \d+ messages of 4 topics in \d/);

    const { reader, messages } = await readIndexed(file("whole.mcap"));
    assert.equal(reader.header.profile, "ros2");
    const topics = [...reader.channelsById.values()].map((channel) => channel.topic).sort();
    assert.deepEqual(topics, ["/io/camera/compressed", "/io/program", "/io/state", "/io/variables"]);
    for (const channel of reader.channelsById.values()) {
      assert.equal(channel.messageEncoding, "cdr");
      assert.match(channel.metadata.get("offered_qos_profiles"), /reliability: (reliable|best_effort)/);
      assert.equal(reader.schemasById.get(channel.schemaId).encoding, "ros2msg");
    }

    const of = (topic) => messages.filter((message) => message.topic === topic);
    const decoded = (topic) => {
      const channel = [...reader.channelsById.values()].find((c) => c.topic === topic);
      const schema = reader.schemasById.get(channel.schemaId);
      const decoder = new MessageReader(definitionsOf(schema));
      return of(topic).map((message) => decoder.readMessage(message.data));
    };
    const states = decoded("/io/state");
    assert.ok(states.length > 100, `${states.length} states`);
    states.forEach((state, i) => {
      assert.equal(state.tick, states[0].tick + BigInt(i), "a state is missing");
      assert.equal(state.robot, "io");
      assert.equal(state.x_m, Number(state.tick) * 0.01);
    });
    assert.deepEqual(decoded("/io/program")[0].states.map((state) => state.name), ["talk", "breathe"]);
    assert.equal(decoded("/io/variables")[0].items[0].certainty, 0.75);
    assert.equal(decoded("/io/camera/compressed")[0].data.length, 5000);
    of("/io/state").forEach((message, i, all) => {
      assert.equal(message.sequence, all[0].sequence + i, "its writer's number of the message");
      assert.ok(message.publishTime <= message.logTime, "recorded before it was said");
      assert.ok(i === 0 || all[i - 1].logTime <= message.logTime);
    });

    const told = info(file("whole.mcap"));
    assert.equal(told.messages, messages.length);
    assert.equal(told.recovered, false);
    assert.equal(told.compression, "zstd");
    assert.ok(told.chunks >= 2);
    assert.ok(told.duration_seconds > 1.5 && told.duration_seconds < 4, `${told.duration_seconds} s`);
    const state = told.channels.find((channel) => channel.topic === "/io/state");
    assert.equal(state.type, "galilean_msgs/msg/RobotState");
    assert.equal(state.messages, states.length);
  });

  test("in IDL it decodes to the same", async () => {
    const recorder = record("idl.mcap", "--duration", "1", "--schema", "ros2idl", "--topics", "^/io/state$");
    await endsWell(recorder);
    const { reader, messages } = await readIndexed(file("idl.mcap"));
    const [schema] = reader.schemasById.values();
    assert.equal(schema.encoding, "ros2idl");
    const decoder = new MessageReader(definitionsOf(schema));
    assert.ok(messages.length > 20, `${messages.length} messages`);
    for (const { data } of messages) assert.equal(decoder.readMessage(data).robot, "io");
  });

  test("has the data section's checksum right", async () => {
    const records = readStream(file("whole.mcap"));
    assert.equal(records.at(-1).type, "Footer");
    const bytes = readFileSync(file("whole.mcap"));
    const end = Number(records.at(-1).summaryStart) - DATA_END_BYTES;
    assert.equal(bytes[end], 0x0f, "DataEnd does not stand before the summary");
    assert.equal(records.find((record) => record.type === "DataEnd").dataSectionCrc, crc32(bytes.subarray(0, end)));
  });

  test("that is damaged gives what is whole, and names what is lost, with and without its summary", async () => {
    const { reader, messages } = await readIndexed(file("whole.mcap"));
    const [, chunk] = reader.chunkIndexes;
    const at = Number(chunk.chunkStartOffset);
    const lost = messages.filter(({ logTime }) => logTime >= chunk.messageStartTime && logTime <= chunk.messageEndTime);
    assert.ok(lost.length > 0 && lost.length < messages.length);
    const topics = {};
    for (const { channelId } of lost) {
      const { topic } = reader.channelsById.get(channelId);
      topics[topic] = (topics[topic] ?? 0) + 1;
    }
    const bytes = readFileSync(file("whole.mcap"));
    bytes[at + CHUNK_CRC_AT] ^= 0xff;
    for (const end of [bytes.length, bytes.length - 20]) {
      writeFileSync(file("damaged.mcap"), bytes.subarray(0, end));
      const told = info(file("damaged.mcap"), 3);
      assert.equal(told.damage.length, 1);
      const [damage] = told.damage;
      assert.equal(damage.what, `the chunk at byte ${at} does not match its checksum`);
      assert.equal(damage.byte, at);
      assert.equal(damage.messages, lost.length);
      assert.equal(damage.start_ns, String(chunk.messageStartTime));
      assert.equal(damage.end_ns, String(chunk.messageEndTime));
      assert.deepEqual(Object.entries(damage.topics).sort(), Object.entries(topics).sort());
      assert.equal(told.recovered, true);
      assert.equal(told.closed, end === bytes.length);
      assert.equal(told.lost.messages, lost.length);
      assert.equal(told.lost.exact, end === bytes.length);
      assert.equal(told.messages, messages.length - lost.length);
    }
  });

  test("that is being written says so, and is not called damaged", async () => {
    const recorder = record("growing.mcap");
    await grown("growing.mcap", 20_000);
    const told = info(file("growing.mcap"));
    assert.equal(told.being_written, true);
    assert.equal(told.recovered, false);
    assert.ok(told.messages > 0);
    const text = spawnSync(program("galilean-log"), ["info", file("growing.mcap")], limit).stdout.toString();
    assert.match(text, /growing\.mcap is being written; it has \d+ messages so far\n/);
    recorder.kill("SIGINT");
    await recorder.ended;
    assert.equal(info(file("growing.mcap")).being_written, false);
  });

  test("is closed properly when it is interrupted", async () => {
    for (const signal of ["SIGINT", "SIGTERM"]) {
      const name = `${signal}.mcap`;
      const recorder = record(name);
      await grown(name, 20_000);
      recorder.kill(signal);
      await endsWell(recorder);
      assert.equal(info(file(name)).recovered, false);
      assert.ok((await readIndexed(file(name))).messages.length > 0);
    }
  });

  test("that was killed is readable up to its last chunk", async () => {
    const recorder = record("killed.mcap");
    await grown("killed.mcap", 20_000);
    recorder.kill("SIGKILL");
    await recorder.ended;
    const told = info(file("killed.mcap"), 3);
    assert.equal(told.recovered, true);
    assert.ok(told.messages > 50);
    const text = spawnSync(program("galilean-log"), ["info", file("killed.mcap")], limit).stdout.toString();
    assert.match(text, /was not closed properly; recovered \d+ messages/);
    const messages = readStream(file("killed.mcap")).filter((record) => record.type === "Message");
    assert.equal(messages.length, told.messages);
  });

  test("keeps what fits when the disk is full", async () => {
    // A limit on the size of files stands for the disk.
    const script = `ulimit -f 200; exec "$0" --out "$1" --domain ${domain}`;
    const recorder = start("/bin/bash", ["-c", script, program("galilean-record"), file("full.mcap")]);
    assert.equal((await recorder.ended).code, 1);
    assert.match(recorder.text, /^galilean-record: .*full\.mcap cannot be written: File too large, by the limit that 'ulimit -f' shows; [^\n]*\n$/);
    const told = info(file("full.mcap"), 3);
    assert.equal(told.recovered, true);
    assert.ok(told.messages > 10);
  });

  test("has only the topics that were asked for", async () => {
    const recorder = record("some.mcap", "--topics", "/(state|program)$", "--duration", "1.5");
    await endsWell(recorder);
    const topics = info(file("some.mcap")).channels.map((channel) => channel.topic);
    assert.deepEqual(topics, ["/io/program", "/io/state"]);
  });

  test("leaves pictures out where they are not wanted", async () => {
    const recorder = record("blind.mcap", "--no-images", "--duration", "1.5");
    await endsWell(recorder);
    const topics = info(file("blind.mcap")).channels.map((channel) => channel.topic);
    assert.deepEqual(topics, ["/io/program", "/io/state", "/io/variables"]);
  });

  test("that cannot begin says why in one line", () => {
    const cases = [
      [["--out", file("whole.mcap")], /exists already/],
      [["--out", "/nonexistent/x.mcap"], /No such file or directory/],
    ];
    for (const [options, reason] of cases) {
      const ended = spawnSync(program("galilean-record"), [...options, "--domain", domain], limit);
      assert.equal(ended.status, 1);
      assert.match(ended.stderr.toString(), reason);
      assert.equal(ended.stderr.toString().trim().split("\n").length, 1);
    }
    writeFileSync(file("empty.mcap"), "");
    for (const none of ["/nonexistent.mcap", program("galilean-log"), file("empty.mcap"), folder]) {
      const ended = spawnSync(program("galilean-log"), ["info", none], limit);
      assert.equal(ended.status, 1);
      assert.equal(ended.stderr.toString().trim().split("\n").length, 1);
    }
  });
});
