// SPDX-License-Identifier: BSD-3-Clause
// Recordings that are too long to be made by waiting.
import { closeSync, openSync, readFileSync, writeSync } from 'node:fs';

const MAGIC = Buffer.from([0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a]);
const [HEADER, FOOTER, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX, STATISTICS, METADATA, DATA_END] = [1, 2, 4, 5, 6, 7, 8, 0xb, 0xc, 0xf];
/** Opcode and length. */
const HEAD = 9;
/** Of an uncompressed chunk, what stands before its records: times, sizes, checksum, the name of no compression. */
const CHUNK_HEAD = 40;
/** In a message's record. */
const [SEQUENCE, LOG_TIME, PUBLISH_TIME] = [HEAD + 2, HEAD + 6, HEAD + 14];
const SECOND_NS = 1_000_000_000n;

const u16 = (value) => { const bytes = Buffer.alloc(2); bytes.writeUInt16LE(value); return bytes; };
const u32 = (value) => { const bytes = Buffer.alloc(4); bytes.writeUInt32LE(value); return bytes; };
const u64 = (value) => { const bytes = Buffer.alloc(8); bytes.writeBigUInt64LE(BigInt(value)); return bytes; };
const text = (value) => Buffer.concat([u32(Buffer.byteLength(value)), Buffer.from(value)]);
const list = (...parts) => { const bytes = Buffer.concat(parts); return Buffer.concat([u32(bytes.length), bytes]); };
const record = (opcode, ...parts) => { const bytes = Buffer.concat(parts); return Buffer.concat([Buffer.from([opcode]), u64(bytes.length), bytes]); };
const textAt = (bytes, at) => bytes.toString('utf8', at + 4, at + 4 + bytes.readUInt32LE(at));

function* recordsOf(bytes, at) {
  while (at + HEAD <= bytes.length) {
    const end = at + HEAD + Number(bytes.readBigUInt64LE(at + 1));
    yield { opcode: bytes[at], whole: bytes.subarray(at, end), body: bytes.subarray(at + HEAD, end) };
    at = end;
  }
}

function chunkOf(records, start_ns, end_ns) {
  const head = [u64(start_ns), u64(end_ns), u64(records.length), u32(0), u32(0), u64(records.length)];
  return Buffer.concat([Buffer.from([CHUNK]), u64(CHUNK_HEAD + records.length), ...head, records]);
}

/** What a recording repeats of one of its chunks: messages with their numbers and times, which are changed in place. */
class Repeated {
  messages = [];

  constructor(body, isLeftOut, channels) {
    if (body.readUInt32LE(28) !== 0) throw new Error('the recording that is repeated must not be compressed');
    this.others = [];
    for (const { opcode, whole, body: inner } of recordsOf(body.subarray(CHUNK_HEAD), 0)) {
      if (opcode === CHANNEL && isLeftOut.test(textAt(inner, 4))) channels.leftOut.add(inner.readUInt16LE(0));
      if (opcode === MESSAGE) this.#take(whole, inner.readUInt16LE(0), channels);
      else this.others.push(whole);
    }
  }

  #take(whole, channel, { leftOut, numbers }) {
    if (leftOut.has(channel)) return;
    const sequence = whole.readUInt32LE(SEQUENCE);
    const known = numbers.get(channel) ?? { first: sequence, last: sequence };
    numbers.set(channel, { first: known.first, last: Math.max(known.last, sequence) });
    this.messages.push({ bytes: Buffer.from(whole), channel, sequence, log_ns: whole.readBigUInt64LE(LOG_TIME), publish_ns: whole.readBigUInt64LE(PUBLISH_TIME) });
  }

  /** The chunk, `times` spans later. */
  at(times, span_ns, numbers) {
    const later_ns = BigInt(times) * span_ns;
    for (const { bytes, channel, sequence, log_ns, publish_ns } of this.messages) {
      const { first, last } = numbers.get(channel);
      bytes.writeUInt32LE((sequence + times * (last - first + 1)) >>> 0, SEQUENCE);
      bytes.writeBigUInt64LE(log_ns + later_ns, LOG_TIME);
      bytes.writeBigUInt64LE(publish_ns + later_ns, PUBLISH_TIME);
    }
    const times_ns = this.messages.map(({ log_ns }) => log_ns + later_ns);
    const [start_ns, end_ns] = times_ns.reduce(([least, most], each) => [each < least ? each : least, each > most ? each : most], [times_ns[0] ?? 0n, 0n]);
    return chunkOf(Buffer.concat([...(times === 0 ? this.others : []), ...this.messages.map(({ bytes }) => bytes)]), start_ns, end_ns);
  }
}

/**
 * Writes to `to` what the uncompressed recording `from` has, `times` times, one behind the other, with numbers and log
 * times that go on. It has no summary. Topics that match `isLeftOut` are left out, and so is what its recorder counted.
 */
export function repeat(from, to, times, isLeftOut = /\/inputs$/) {
  const channels = { leftOut: new Set(), numbers: new Map() };
  const [begin, chunks] = [[MAGIC], []];
  for (const { opcode, whole, body } of recordsOf(readFileSync(from), MAGIC.length)) {
    if (opcode === DATA_END) break;
    if (opcode === CHUNK) chunks.push(new Repeated(body, isLeftOut, channels));
    else if (opcode !== MESSAGE_INDEX && !(opcode === METADATA && textAt(body, 0).startsWith('losses'))) begin.push(whole);
  }
  const times_ns = chunks.flatMap(({ messages }) => messages.map(({ log_ns }) => log_ns)).sort((a, b) => (a < b ? -1 : 1));
  const span_ns = times_ns.at(-1) - times_ns[0] + SECOND_NS / 10n;
  const file = openSync(to, 'w');
  writeSync(file, Buffer.concat(begin));
  for (let time = 0; time < times; ++time) for (const chunk of chunks) if (chunk.messages.length > 0 || time === 0) writeSync(file, chunk.at(time, span_ns, channels.numbers));
  writeSync(file, Buffer.concat([record(DATA_END, u32(0)), record(FOOTER, u64(0), u64(0), u32(0)), MAGIC]));
  closeSync(file);
}

const [HOLE_BYTES, HOLE_MESSAGES] = [1 << 20, 100];

/** Writes a recording of `bytes` with indexes and a summary. What its chunks hold is a hole, which takes no room on the disk. */
export function writeHollow(to, bytes) {
  const file = openSync(to, 'w');
  const indexes = [];
  let at = 0;
  const put = (...parts) => { for (const part of parts) at += writeSync(file, part, 0, part.length, at); };
  const channel = record(CHANNEL, u16(1), u16(0), text('/t'), text('cdr'), u32(0));
  put(MAGIC, record(HEADER, text('ros2'), text('bench')), channel);
  for (let time_ns = 1n; at < bytes; time_ns += SECOND_NS) {
    const began = at;
    put(Buffer.concat([Buffer.from([CHUNK]), u64(CHUNK_HEAD + HOLE_BYTES), u64(time_ns), u64(time_ns), u64(HOLE_BYTES), u32(0), u32(0), u64(HOLE_BYTES)]));
    at += HOLE_BYTES;
    const [length, indexAt] = [at - began, at];
    put(record(MESSAGE_INDEX, u16(1), list(...Array.from({ length: HOLE_MESSAGES }, (_, i) => Buffer.concat([u64(time_ns), u64(i * 1000)])))));
    indexes.push(record(CHUNK_INDEX, u64(time_ns), u64(time_ns), u64(began), u64(length), list(u16(1), u64(indexAt)), u64(at - indexAt), text(''), u64(HOLE_BYTES), u64(HOLE_BYTES)));
  }
  put(record(DATA_END, u32(0)));
  const [summary, messages, last_ns] = [at, indexes.length * HOLE_MESSAGES, 1n + BigInt(indexes.length - 1) * SECOND_NS];
  const statistics = record(STATISTICS, u64(messages), u16(0), u32(1), u32(0), u32(0), u32(indexes.length), u64(1), u64(last_ns), list(u16(1), u64(messages)));
  put(channel, statistics, ...indexes, record(FOOTER, u64(summary), u64(0), u32(0)), MAGIC);
  closeSync(file);
}
