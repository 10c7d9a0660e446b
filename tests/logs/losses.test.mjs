// SPDX-License-Identifier: BSD-3-Clause
// Nothing is lost in silence: what was published is recorded, or counted as lost, whatever drops it: the network, the
// recorder's disk, or the end of who writes.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { closeSync, constants, mkdtempSync, openSync, readSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { freshDomain } from "../tools/domain.mjs";
import { eventually } from "../tools/patience.mjs";
import { info, limit, program, readIndexed, start, testTool } from "./tools.mjs";

const folder = mkdtempSync(path.join(tmpdir(), "galilean-losses-"));
const file = (name) => path.join(folder, name);
after(() => rmSync(folder, { recursive: true }));

/** Commands run as they are. */
const HERE = [];
/** Cyclone's own fault injection: of a thousand packets that a process sends, so many are dropped. */
const dropping = (per_mille) => ({
  ...process.env,
  CYCLONEDDS_URI: `<CycloneDDS><Domain id="any"><Internal><Test><XmitLossiness>${per_mille}</XmitLossiness></Test></Internal></Domain></CycloneDDS>`,
});

/** A talker that says at the end how many messages it has published. */
function talk(domain, { env = process.env, within_network = HERE } = {}) {
  const command = [...within_network, testTool("wire_talker"), "io", domain];
  const talker = start(command[0], command.slice(1), { env });
  talker.stop = async () => {
    talker.stdin.write("\n");
    const said = () => talker.text.match(/^\{.*\}$/m);
    await eventually(said);
    return JSON.parse(said()[0]);
  };
  talker.leave = async () => {
    talker.stdin.end();
    await talker.ended;
  };
  return talker;
}

const record = (name, domain, { env = process.env, within_network = HERE } = {}, ...options) => {
  const command = [...within_network, program("galilean-record"), "--out", file(name), "--domain", domain, "--picture-rate", "0", ...options];
  return start(command[0], command.slice(1), { env });
};
const grown = (name, size) => eventually(() => statSync(file(name), { throwIfNoEntry: false })?.size > size);

/** By topic, from the messages themselves: how many there are, the first number and the last. */
async function numbers(name) {
  const { messages } = await readIndexed(file(name));
  const all = {};
  for (const { topic, sequence } of messages) {
    if (!topic.startsWith("/io/")) continue;
    const known = (all[topic] ??= { count: 0, first: sequence, last: sequence });
    ++known.count;
    known.last = sequence;
  }
  return all;
}

/**
 * Compares what the file holds with what its recorder told and with what was published: each message that was sent until
 * the last that came is in the file, or was sent before it listened, or counts as lost. `published` may be undefined.
 */
async function adds_up(name, published) {
  const { losses } = info(file(name));
  assert.equal(losses.complete, true);
  const held = await numbers(name);
  let lost = 0;
  for (const [topic, { count, first, last }] of Object.entries(held)) {
    const told = losses.writers.find((each) => each.topic === topic) ?? { recorded: count, not_received: 0, sent_before: 0 };
    assert.equal(told.recorded, count, topic);
    assert.equal(told.sent_before, first - 1, topic);
    assert.equal(told.sent_before + told.recorded + told.not_received, last, topic);
    lost += told.not_received;
    const sent = published?.[topic.slice("/io/".length)];
    // What was sent after the last that came cannot be known. Of a reliable writer, that is nothing.
    if (sent !== undefined) assert.ok(topic.endsWith("compressed") ? sent - last >= 0 && sent - last < 60 : sent === last, `${topic}: ${sent} sent, the last that came is ${last}`);
  }
  assert.equal(losses.missing, lost);
  return { losses, held, lost };
}

async function survives_dropped_packets(name, domain, where) {
  const talker = talk(domain, where);
  const recorder = record(name, domain, where);
  await grown(name, 200_000);
  await sleep(2000);
  const published = await talker.stop();
  await sleep(2000); // for what a reliable writer sends again
  recorder.kill("SIGINT");
  const { code } = await recorder.ended;
  await talker.leave();
  const { losses, lost } = await adds_up(name, published);
  const pictures = losses.writers.find(({ topic }) => topic === "/io/camera/compressed");
  assert.ok(pictures.not_received > 0.05 * published["camera/compressed"], `${pictures.not_received} of ${published["camera/compressed"]} pictures were lost`);
  assert.equal(code, 3, recorder.text);
  assert.match(recorder.text, new RegExp(`/io/camera/compressed lost ${pictures.not_received} of \\d+ messages of io`));
  assert.ok(lost >= pictures.not_received);
}

test("of a fifth of packets dropped by DDS, all that was published is recorded or counted", async () => {
  await survives_dropped_packets("dropped.mcap", freshDomain(), { env: dropping(200) });
});

/** A network of the test's own that drops a fifth of its packets; undefined where this machine cannot make one. */
async function lossy_network(t) {
  const rules = "nft add table ip t && nft add chain ip t c '{ type filter hook input priority 0; }' && nft add rule ip t c ip protocol udp numgen random mod 100 '<' 20 drop";
  const netem = "tc qdisc add dev lo root netem loss 20%";
  const unprivileged = process.getuid() === 0 ? [] : ["--user", "--map-root-user"];
  const holder = spawn("unshare", [...unprivileged, "--net", "bash", "-c", `ip link set lo up multicast on && { { ${netem}; } || { ${rules}; }; } 2>/dev/null && echo ready; exec cat`]);
  let text = "";
  holder.stdout.on("data", (data) => (text += data));
  const closed = new Promise((resolve) => holder.on("close", resolve));
  holder.on("error", () => {});
  t.after(() => {
    holder.stdin.end();
    return closed;
  });
  holder.stdin.write("made\n"); // which cat says once the rules stand, or could not be made
  await Promise.race([eventually(() => text.includes("made")), closed]);
  if (!text.includes("ready")) return undefined;
  const users = unprivileged.length > 0 ? [`--user=/proc/${holder.pid}/ns/user`, "--preserve-credentials"] : [];
  return ["nsenter", ...users, `--net=/proc/${holder.pid}/ns/net`, "--"];
}

test("of a fifth of packets dropped by the network, all that was published is recorded or counted", async (t) => {
  const within_network = await lossy_network(t);
  if (!within_network) return t.skip("needs unshare, ip, and tc with netem or nft: no network can be made that drops packets");
  await survives_dropped_packets("network.mcap", freshDomain(), { within_network });
});

test("while its disk stalls, a recorder counts what it could not take", async () => {
  const domain = freshDomain();
  const pipe = file("pipe");
  assert.equal(spawnSync("mkfifo", [pipe], limit).status, 0);
  const reader = openSync(pipe, constants.O_RDONLY | constants.O_NONBLOCK);
  const talker = talk(domain);
  const recorder = record("pipe", domain, {}, "--compression", "none");
  const pieces = [];
  const piece = Buffer.alloc(1 << 16);
  const drain = () => {
    try {
      for (let size; (size = readSync(reader, piece)) > 0; ) pieces.push(Buffer.from(piece.subarray(0, size)));
    } catch (error) {
      if (error.code !== "EAGAIN") throw error;
    }
  };
  const size = () => pieces.reduce((sum, { length }) => sum + length, 0);
  await eventually(() => (drain(), size() > 100_000));
  await sleep(10_000); // nobody reads: the pipe is full after a moment, and the queue of pictures soon after it
  let drains = true;
  const draining = (async () => {
    while (drains) {
      drain();
      await sleep(5);
    }
  })();
  const before = size();
  await eventually(() => size() > before + 500_000);
  const published = await talker.stop();
  await sleep(1000);
  recorder.kill("SIGINT");
  const { code } = await recorder.ended;
  drains = false;
  await draining;
  drain();
  closeSync(reader);
  await talker.leave();
  writeFileSync(file("stalled.mcap"), Buffer.concat(pieces));
  const { losses } = await adds_up("stalled.mcap", published);
  const pictures = losses.writers.find(({ topic }) => topic === "/io/camera/compressed");
  assert.ok(pictures.overrun > 0, JSON.stringify(pictures));
  assert.equal(code, 3, recorder.text);
  assert.match(recorder.text, /\/io\/camera\/compressed lost \d+ of \d+ messages of io, \d+ of them because the recorder was too slow/);
});

test("of a writer that was killed, all is accounted for until its last message", async () => {
  const domain = freshDomain();
  const talker = talk(domain);
  const recorder = record("killed.mcap", domain);
  await grown("killed.mcap", 100_000);
  talker.kill("SIGKILL");
  await talker.ended;
  await sleep(1500);
  const second = talk(domain); // another process of the same name: other writers, other numbers
  const size = statSync(file("killed.mcap")).size;
  await grown("killed.mcap", size + 100_000);
  await second.stop();
  recorder.kill("SIGINT");
  const { code } = await recorder.ended;
  await second.leave();
  const { losses, recovered } = info(file("killed.mcap"));
  assert.equal(recovered, false);
  assert.equal(code, losses.missing > 0 ? 3 : 0, recorder.text);
  const { reader, messages } = await readIndexed(file("killed.mcap"));
  const writers = new Map();
  for (const { topic, channelId, sequence } of messages) {
    if (!topic.startsWith("/io/")) continue;
    const { metadata } = reader.channelsById.get(channelId);
    const known = writers.get(metadata.get("writer")) ?? { topic, count: 0, first: sequence };
    writers.set(metadata.get("writer"), { ...known, count: known.count + 1, last: sequence });
  }
  assert.equal([...writers.values()].filter(({ topic }) => topic === "/io/state").length, 2);
  for (const [guid, { topic, count, first, last }] of writers) {
    const told = losses.writers.find(({ writer }) => writer === guid) ?? { recorded: count, not_received: 0, sent_before: first - 1 };
    assert.equal(told.sent_before + told.recorded + told.not_received, last, `${topic} of ${guid}`);
    assert.equal(told.recorded, count, `${topic} of ${guid}`);
  }
});
