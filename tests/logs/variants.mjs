// SPDX-License-Identifier: BSD-3-Clause
// Files in every variant that MCAP allows, made by its reference library's record builder: with and without chunks,
// indexes, repeated records, statistics, summary offsets and padding behind records. The variants are those of MCAP's
// own conformance suite (mcap.dev/guides, "Conformance tests").
import { crc32 } from "./crc32.mjs";
import { McapChunkBuilder, McapRecordBuilder } from "./tools.mjs";

const bytes = (...numbers) => Uint8Array.from(numbers);
const schema = { id: 1, name: "Example", encoding: "c", data: bytes(4, 5, 6) };
const channel = { id: 1, schemaId: 1, topic: "example", messageEncoding: "a", metadata: new Map([["foo", "bar"]]) };
const message = (sequence, time) =>
  ({ channelId: 1, sequence, logTime: BigInt(time), publishTime: BigInt(time), data: bytes(1, 2, 3) });

/** By name: what a file holds, and which features make a difference to it. */
export const INPUTS = {
  NoData: { records: [], features: ["st", "sum", "pad"] },
  OneMetadata: {
    records: [{ type: "Metadata", name: "myMetadata", metadata: new Map([["foo", "bar"]]) }],
    features: ["mdx", "st", "sum", "pad"],
  },
  OneAttachment: {
    records: [{ type: "Attachment", name: "myFile", logTime: 2n, createTime: 1n, mediaType: "text/plain", data: bytes(1, 2, 3) }],
    features: ["ax", "st", "sum", "pad"],
  },
  OneSchemalessMessage: {
    records: [{ type: "Channel", ...channel, schemaId: 0 }, { type: "Message", ...message(10, 2) }],
    features: ["ch", "mx", "chx", "rch", "st", "sum", "pad"],
  },
  OneMessage: {
    records: [{ type: "Schema", ...schema }, { type: "Channel", ...channel }, { type: "Message", ...message(10, 2) }],
    features: ["ch", "mx", "chx", "rsh", "rch", "st", "sum", "pad"],
  },
  TenMessages: {
    records: [
      { type: "Schema", ...schema },
      { type: "Channel", ...channel },
      ...[0, 2, 1, 3, 3, 5, 4, 7, 8, 9].map((time, i) => ({ type: "Message", ...message(i, time) })),
    ],
    features: ["ch", "mx", "chx", "rsh", "rch", "st", "sum", "pad"],
  },
};

/** Every set of the features that makes a file: indexes of chunks need chunks. */
export function* variantsOf(features) {
  for (let set = 0; set < 2 ** features.length; ++set) {
    const chosen = new Set(features.filter((_, i) => set & (1 << i)));
    if (chosen.has("ch") || !(chosen.has("mx") || chosen.has("chx"))) yield chosen;
  }
}

const concatenated = (parts) => new Uint8Array(Buffer.concat(parts));

/** The bytes of a file of these records in this variant. */
export function fileOf(records, features) {
  const builder = new McapRecordBuilder({ padRecords: features.has("pad") });
  const parts = [];
  const size = () => BigInt(parts.reduce((sum, part) => sum + part.length, 0));
  const put = (write) => {
    write(builder);
    parts.push(builder.buffer.slice());
    builder.reset();
  };
  const of = (type) => records.filter((record) => record.type === type);
  const writeOne = (record) => (to) => to[`write${record.type}`](record);

  put((to) => to.writeMagic());
  put((to) => to.writeHeader({ profile: "", library: "" }));
  const indexes = { Chunk: [], Attachment: [], Metadata: [] };
  const inChunks = (record) => features.has("ch") && ["Schema", "Channel", "Message"].includes(record.type);
  for (const record of records.filter((each) => !inChunks(each))) {
    const offset = size();
    put(writeOne(record));
    if (record.type in indexes) indexes[record.type].push({ ...record, offset, length: size() - offset, dataSize: BigInt(record.data?.length ?? 0) });
  }
  if (records.some(inChunks)) indexes.Chunk.push(putChunk(records.filter(inChunks), features, put, size));

  const dataSectionCrc = crc32(concatenated(parts));
  put((to) => to.writeDataEnd({ dataSectionCrc }));
  putSummary({ of, indexes, features, put, size, writeOne, parts, builder });
  put((to) => to.writeMagic());
  return concatenated(parts);
}

function putChunk(records, features, put, size) {
  const chunk = new McapChunkBuilder({ useMessageIndex: features.has("mx") });
  for (const record of records) chunk[`add${record.type}`](record);
  const chunkStartOffset = size();
  const { messageStartTime, messageEndTime } = chunk;
  const uncompressedSize = BigInt(chunk.buffer.length);
  const uncompressedCrc = crc32(chunk.buffer);
  put((to) => to.writeChunk({ messageStartTime, messageEndTime, uncompressedSize, uncompressedCrc, compression: "", records: chunk.buffer }));
  const chunkLength = size() - chunkStartOffset;
  const messageIndexOffsets = new Map();
  const indexStart = size();
  for (const index of chunk.indices) {
    messageIndexOffsets.set(index.channelId, size());
    put((to) => to.writeMessageIndex(index));
  }
  return {
    messageStartTime, messageEndTime, chunkStartOffset, chunkLength, messageIndexOffsets,
    messageIndexLength: size() - indexStart, compression: "", compressedSize: uncompressedSize, uncompressedSize,
  };
}

function putSummary({ of, indexes, features, put, size, writeOne, parts, builder }) {
  const first = parts.length;
  const summaryStart = size();
  const messages = of("Message");
  const times = messages.map(({ logTime }) => Number(logTime));
  const statistics = {
    messageCount: BigInt(messages.length), schemaCount: of("Schema").length, channelCount: of("Channel").length,
    attachmentCount: of("Attachment").length, metadataCount: of("Metadata").length, chunkCount: indexes.Chunk.length,
    messageStartTime: BigInt(times.length ? Math.min(...times) : 0), messageEndTime: BigInt(times.length ? Math.max(...times) : 0),
    channelMessageCounts: new Map(messages.length ? [[1, BigInt(messages.length)]] : []),
  };
  const groups = [
    ["rsh", 0x03, of("Schema").map(writeOne)],
    ["rch", 0x04, of("Channel").map(writeOne)],
    ["st", 0x0b, [(to) => to.writeStatistics(statistics)]],
    ["mdx", 0x0d, indexes.Metadata.map((index) => (to) => to.writeMetadataIndex(index))],
    ["ax", 0x0a, indexes.Attachment.map((index) => (to) => to.writeAttachmentIndex(index))],
    ["chx", 0x08, indexes.Chunk.map((index) => (to) => to.writeChunkIndex(index))],
  ];
  const offsets = [];
  for (const [feature, groupOpcode, writes] of groups.filter(([name, , all]) => features.has(name) && all.length > 0)) {
    const groupStart = size();
    writes.forEach(put);
    offsets.push({ groupOpcode, groupStart, groupLength: size() - groupStart, feature });
  }
  const summaryOffsetStart = features.has("sum") && offsets.length > 0 ? size() : 0n;
  if (features.has("sum")) for (const offset of offsets) put((to) => to.writeSummaryOffset(offset));
  const footer = { summaryStart: offsets.length > 0 ? summaryStart : 0n, summaryOffsetStart, summaryCrc: 0 };
  builder.writeFooter(footer);
  const before = concatenated([...parts.slice(first), builder.buffer.slice(0, -4)]);
  builder.reset();
  put((to) => to.writeFooter({ ...footer, summaryCrc: crc32(before) }));
}
