// SPDX-License-Identifier: BSD-3-Clause
// `log info` tells the truth of a file in every variant that the format allows: what the data section holds counts,
// whatever the summary leaves out. MCAP's reference reader reads the same files, so that a mistake of the test shows.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, describe, test } from "node:test";
import { McapStreamReader, limit, program } from "./tools.mjs";
import { INPUTS, fileOf, variantsOf } from "./variants.mjs";

const folder = mkdtempSync(path.join(tmpdir(), "galilean-variants-"));
after(() => rmSync(folder, { recursive: true }));

function info(name, bytes) {
  const file = path.join(folder, name);
  writeFileSync(file, bytes);
  const { status, stdout, stderr } = spawnSync(program("galilean-log"), ["info", file, "--json"], limit);
  assert.equal(status, 0, `${name}: ${stderr}${stdout}`);
  return JSON.parse(stdout);
}

function recordsOf(bytes) {
  const reader = new McapStreamReader({ validateCrcs: true });
  reader.append(bytes);
  const records = [];
  for (let record; (record = reader.nextRecord()); ) records.push(record);
  return records;
}

/** What `log info` must say of these records. */
function expected(records, chunked) {
  const of = (type) => records.filter((record) => record.type === type);
  const messages = of("Message");
  const times = messages.map(({ logTime }) => Number(logTime));
  return {
    library: "", profile: "",
    start_ns: String(times.length ? Math.min(...times) : 0), end_ns: String(times.length ? Math.max(...times) : 0),
    messages: messages.length, chunks: chunked && messages.length ? 1 : 0, recovered: false, checked: true, damage: [],
    lost: { messages: 0, exact: true, topics: {} },
    channels: of("Channel").map(({ id, schemaId, topic, messageEncoding, metadata }) => ({
      topic, type: of("Schema").find((schema) => schema.id === schemaId)?.name ?? "", messages: messages.length, id,
      schema_id: schemaId, message_encoding: messageEncoding, metadata: Object.fromEntries(metadata),
    })),
    schemas: of("Schema").map(({ id, name, encoding, data }) =>
      ({ id, name, encoding, bytes: data.length, data: { text: Buffer.from(data).toString() } })),
    attachments: of("Attachment").map(({ name, mediaType, data, logTime, createTime }) =>
      ({ name, media_type: mediaType, bytes: data.length, logged_ns: String(logTime), created_ns: String(createTime) })),
    metadata_records: of("Metadata").map(({ name, metadata }) => ({ name, entries: Object.fromEntries(metadata) })),
  };
}

/** `told` without what `wanted` does not speak of. */
function withoutRest(told, wanted) {
  if (Array.isArray(wanted)) return told.map((each, i) => (i in wanted ? withoutRest(each, wanted[i]) : each));
  if (!wanted || typeof wanted !== "object" || Object.keys(wanted).length === 0) return told;
  return Object.fromEntries(Object.keys(wanted).map((key) => [key, withoutRest(told[key], wanted[key])]));
}

describe("a file in every variant of the format", () => {
  for (const [name, { records, features }] of Object.entries(INPUTS))
    test(`${name} is told as it is`, () => {
      let variants = 0;
      for (const chosen of variantsOf(features)) {
        const file = `${[name, ...chosen].join("-")}.mcap`;
        const bytes = fileOf(records, chosen);
        const read = recordsOf(bytes).filter(({ type }) => records.some((record) => record.type === type));
        assert.ok(read.length >= records.length, `${file} is not what the test means`);
        const wanted = expected(records, chosen.has("ch"));
        assert.deepEqual(withoutRest(info(file, bytes), wanted), wanted, file);
        ++variants;
      }
      assert.ok(variants >= 8, `${variants} variants`);
    });
});
