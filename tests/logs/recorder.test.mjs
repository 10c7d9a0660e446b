// SPDX-License-Identifier: BSD-3-Clause
// What galilean-record does where something is missing: messages, room, definitions, or somebody to record.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { freshDomain } from "../tools/domain.mjs";
import { within } from "../tools/patience.mjs";
import { MessageReader, definitionsOf, domain, endsWell, info, limit, program, readIndexed, start, testTool } from "./tools.mjs";

const folder = mkdtempSync(path.join(tmpdir(), "galilean-recorder-"));
const file = (name) => path.join(folder, name);
const record = (name, ...options) => start(program("galilean-record"), ["--out", file(name), ...options]);
/** A machine whose network buffers hold little, so that a recorder that stands for two seconds misses something anywhere. */
const SHORT_OF_BUFFERS = {
  ...process.env,
  CYCLONEDDS_URI: `<CycloneDDS><Domain id="any"><Internal><SocketReceiveBufferSize min="default" max="100 kB"/></Internal></Domain></CycloneDDS>`,
};
const recorded = (...args) => spawnSync(program("galilean-record"), args, { maxBuffer: 1 << 28, ...limit });
const grown = async (name, size) => {
  for (let i = 0; i < 1000; ++i) {
    if (statSync(file(name), { throwIfNoEntry: false })?.size > size) return;
    await sleep(10);
  }
  assert.fail(`${name} did not grow to ${size} bytes`);
};
after(() => rmSync(folder, { recursive: true }));

/** By topic: how many numbers are missing between the first and the last that its writer gave its messages. */
function gaps(messages) {
  const last = {}, missing = {};
  for (const { topic, sequence } of messages) {
    missing[topic] = (missing[topic] ?? 0) + (topic in last ? sequence - last[topic] - 1 : 0);
    last[topic] = sequence;
  }
  return missing;
}

describe("beside a robot that talks", () => {
  let talker;
  before(() => (talker = start(testTool("wire_talker"), ["io", domain])));
  after(async () => {
    talker.stdin.end();
    await talker.ended;
  });

  test("what does not come while the recorder stands is counted by topic and writer, told, and ends it with 3", async () => {
    const recorder = start(program("galilean-record"), ["--out", file("lossy.mcap"), "--domain", domain, "--picture-rate", "0"], { env: SHORT_OF_BUFFERS });
    await grown("lossy.mcap", 20_000);
    recorder.kill("SIGSTOP");
    await sleep(2000);
    recorder.kill("SIGCONT");
    await grown("lossy.mcap", statSync(file("lossy.mcap")).size + 50_000);
    recorder.kill("SIGINT");
    assert.equal((await recorder.ended).code, 3, recorder.text);

    const { messages } = await readIndexed(file("lossy.mcap"));
    const missing = gaps(messages.filter(({ topic }) => topic.startsWith("/io/")));
    assert.ok(missing["/io/camera/compressed"] > 0, JSON.stringify(missing));
    const { losses } = info(file("lossy.mcap"), 3);
    assert.equal(losses.complete, true);
    assert.equal(losses.missing, Object.values(missing).reduce((sum, each) => sum + each, 0));
    for (const { topic, process, not_received } of losses.writers) assert.deepEqual([process, not_received], ["io", missing[topic]], topic);
    const pictures = losses.writers.find(({ topic }) => topic === "/io/camera/compressed");
    assert.match(recorder.text, new RegExp(`\\n.*: /io/camera/compressed lost ${pictures.not_received} of ${pictures.not_received + pictures.recorded} messages of io[,\\n]`));
    const told = messages.filter(({ topic }) => topic === "/recorder/losses").map(({ data }) => JSON.parse(new TextDecoder().decode(data)));
    assert.ok(told.some(({ topic, not_received }) => topic === "/io/camera/compressed" && not_received > 0), JSON.stringify(told));
    const text = spawnSync(program("galilean-log"), ["info", file("lossy.mcap")], limit).stdout.toString();
    assert.match(text, new RegExp(`missing: +${losses.missing} messages?\\n`));
    const [, line] = /\/io\/camera\/compressed of io: (.*)\n/.exec(text);
    const counted = [...line.matchAll(/(\d+) lost (because the recorder was too slow|before they reached the recorder)/g)];
    assert.equal(counted.reduce((sum, [, count]) => sum + Number(count), 0), pictures.not_received, line);
    assert.doesNotMatch(line, /(^|, )0 /);
  });

  test("the file tells the number of the domain, whether an option or the environment chose it", () => {
    const chosen = { "option.mcap": [["--domain", domain], {}], "environment.mcap": [[], { ROS_DOMAIN_ID: domain }] };
    for (const [name, [options, environment]] of Object.entries(chosen)) {
      const done = spawnSync(program("galilean-record"), ["--out", file(name), "--duration", "0.5", ...options], { ...limit, env: { ...process.env, ...environment } });
      assert.equal(done.error, undefined);
      assert.equal(info(file(name)).metadata.galilean.domain, domain, name);
    }
  });

  test("what was sent before it listened is told, and is no loss", async () => {
    const recorder = record("late.mcap", "--domain", domain, "--duration", "1", "--topics", "state$");
    await endsWell(recorder);
    const { missing, writers: [state] } = info(file("late.mcap")).losses;
    assert.equal(missing, state.not_received);
    const { messages } = await readIndexed(file("late.mcap"));
    assert.equal(state.sent_before, messages[0].sequence - 1);
    assert.ok(state.sent_before > 0);
  });

  test("into standard output goes nothing but the recording, be it a socket, a pipe or a file", async () => {
    const options = `--domain ${domain} --duration 1`;
    const socket = recorded("--out", "-", ...options.split(" "));
    assert.ok([0, 3].includes(socket.status), socket.stderr.toString());
    writeFileSync(file("socket.mcap"), socket.stdout);
    const shell = (command) => {
      const { status, stderr } = spawnSync("bash", ["-c", `set -o pipefail; ${command}`], limit);
      assert.ok([0, 3].includes(status), stderr.toString());
      assert.match(stderr.toString(), /^standard output: \d+ messages of 4 topics in/m);
    };
    shell(`${program("galilean-record")} --out /dev/stdout ${options} | cat > ${file("pipe.mcap")}`);
    shell(`${program("galilean-record")} --out - ${options} > ${file("redirected.mcap")}`);
    for (const name of ["socket.mcap", "pipe.mcap", "redirected.mcap"]) {
      assert.equal(info(file(name)).recovered, false, name);
      assert.ok((await readIndexed(file(name))).messages.length > 20, name);
    }
  });

  test("a file that is standard output is not spoilt by what the recorder says", () => {
    const out = file("same.mcap");
    const { status, stderr } = spawnSync("bash", ["-c", `${program("galilean-record")} --out ${out} --replace --domain ${domain} --duration 1 >> ${out}`], limit);
    assert.ok([0, 3].includes(status), stderr.toString());
    assert.match(stderr.toString(), /same\.mcap: \d+ messages/);
    assert.equal(info(out).recovered, false);
  });

  test("it goes on in other files, of which each can be read alone, and keeps the newest", async () => {
    const recorder = record("split.mcap", "--domain", domain, "--picture-rate", "0", "--duration", "4.5", "--split-duration", "1", "--max-files", "2");
    await endsWell(recorder);
    const names = readdirSync(folder).filter((name) => name.startsWith("split")).sort();
    assert.equal(names.length, 2, names.join());
    assert.match(recorder.text, new RegExp(`${names[0]} to .*${names[1]}: \\d+ messages of 4 topics in`));
    let last;
    for (const name of names) {
      const { reader, messages } = await readIndexed(file(name));
      assert.equal(info(file(name)).recovered, false);
      const attached = [];
      for await (const each of reader.readAttachments()) attached.push([each.name, new TextDecoder().decode(each.data)]);
      assert.deepEqual(attached, [["3f2a91c0/talk.bhdl", "; talks and breathes\n"]]);
      const program = messages.find(({ topic }) => topic === "/io/program");
      const schema = reader.schemasById.get(reader.channelsById.get(program.channelId).schemaId);
      assert.equal(new MessageReader(definitionsOf(schema)).readMessage(program.data).name, "talk");
      const pictures = messages.filter(({ topic }) => topic === "/io/camera/compressed").map(({ sequence }) => sequence);
      if (last && !/ lost /.test(recorder.text)) assert.equal(pictures[0], last + 1, "a message is in neither file");
      last = pictures.at(-1);
    }
  });

  test("with --on it writes what came shortly before and after an event, and nothing else", async () => {
    const recorder = record("event.mcap", "--domain", domain, "--duration", "4", "--on", "/io/state.tick > 0 for 1.5 s", "--keep-last", "500ms", "--keep-after", "500ms");
    await endsWell(recorder);
    assert.match(recorder.text, /galilean-record: io: [^\n]*: recorded to .*event\.mcap\n/);
    assert.equal(info(file("event.mcap")).recovered, false);
    const { messages } = await readIndexed(file("event.mcap"));
    const times = messages.filter(({ topic }) => topic === "/io/state").map(({ logTime }) => Number(logTime / 1_000_000n));
    assert.ok(times.length > 50, `${times.length} states`);
    assert.ok(times.at(-1) - times[0] > 700 && times.at(-1) - times[0] < 2500, `${times.at(-1) - times[0]} ms`);
    assert.ok(messages.some(({ topic }) => topic === "/io/program"), "a state that was sent long before");

    const waiting = record("never.mcap", "--domain", domain, "--duration", "1", "--on", "/io/state.tick < 0");
    assert.equal((await waiting.ended).code, 0, waiting.text);
    assert.match(waiting.text, /nothing was recorded, because it never came true: \/io\/state\.tick < 0\n/);
    assert.equal(statSync(file("never.mcap"), { throwIfNoEntry: false }), undefined);
    const refused = recorded("--out", file("no.mcap"), "--domain", domain, "--on", "state are stuck");
    assert.equal(refused.status, 2);
    assert.match(refused.stderr.toString(), /^galilean record: --on: 'state are stuck' is no condition: /);
  });

  test("it stands still while the disk is nearly full, and says how much is missing", async () => {
    const recorder = record("full.mcap", "--domain", domain, "--duration", "3", "--min-free", "1000000GB");
    assert.equal((await recorder.ended).code, 3, recorder.text);
    assert.match(recorder.text, /only \d+ MB are free for '.*full\.mcap', less than 1000000000 MB \(--min-free\): nothing is recorded until there is room again; delete something\n/);
    assert.match(recorder.text, /\/io\/state lacks, for want of room on the disk, \d+ of \d+ messages of io\n/);
    const { recovered, losses } = info(file("full.mcap"), 3);
    assert.equal(recovered, false);
    assert.ok(losses.writers.find(({ topic }) => topic === "/io/state").unwritten > 0, JSON.stringify(losses));
  });

  test("it notices that its file was deleted, and no second recorder spoils it", async () => {
    const recorder = record("gone.mcap", "--domain", domain);
    await grown("gone.mcap", 1000);
    const second = recorded("--out", file("gone.mcap"), "--replace", "--domain", domain, "--duration", "1");
    assert.equal(second.status, 1);
    assert.match(second.stderr.toString(), /gone\.mcap is being written by another program; choose another name\n/);
    rmSync(file("gone.mcap"));
    assert.equal((await recorder.ended).code, 1, recorder.text);
    assert.match(recorder.text, /gone\.mcap was deleted or replaced while it was written; what was recorded to it is lost\n/);
  });

  test("it takes what is asked for: expressions, exceptions, pictures, compression, pictures' bytes", async () => {
    const topics = async (name, ...options) => {
      const recorder = record(name, "--domain", domain, "--duration", "2", ...options);
      await endsWell(recorder);
      return info(file(name)).channels.map(({ topic }) => topic);
    };
    assert.deepEqual(await topics("listed.mcap", "--topics", "state$", "program$"), ["/io/program", "/io/state"]);
    assert.deepEqual(await topics("excluded.mcap", "--exclude", "state$", "camera"), ["/io/program", "/io/variables"]);
    assert.deepEqual(await topics("blind.mcap", "--pictures", "none"), ["/io/program", "/io/state", "/io/variables"]);
    await topics("plain.mcap", "--compression", "none", "--picture-rate", "50kB");
    const plain = info(file("plain.mcap"));
    assert.equal(plain.compression, "none");
    const pictures = plain.channels.find(({ topic }) => topic === "/io/camera/compressed");
    assert.ok(pictures.messages >= 5 && pictures.messages <= 40, `${pictures.messages} pictures of 5 kB in 2 s`);
    assert.ok(plain.losses.writers.find(({ topic }) => topic === "/io/camera/compressed").left_out > 20);
  });

  test("a selection that leaves all out is told from a domain where nobody is", async () => {
    const selective = recorded("--out", file("none.mcap"), "--domain", domain, "--duration", "1", "--topics", "^/nobody/");
    assert.equal(selective.status, 0);
    assert.match(selective.stderr.toString(), /^galilean-record: nothing was recorded, because no topic on the wire matches --topics/);
    const alone = recorded("--out", file("alone.mcap"), "--domain", freshDomain(), "--duration", "1");
    assert.equal(alone.status, 0);
    assert.match(alone.stderr.toString(), /^galilean-record: no robot was heard; check that robots run, and in the same DDS domain/);
  });
});

test("topics of every type are recorded, with their definitions where there are any", async (t) => {
  const own = freshDomain();
  const talker = start(testTool("foreign_talker"), [own]);
  t.after(() => {
    talker.stdin.end();
    return talker.ended;
  });
  await within(new Promise((resolve) => talker.stdout.once("data", resolve)), () => "foreign_talker to talk");
  const recorder = record("foreign.mcap", "--domain", own, "--duration", "4");
  await endsWell(recorder);
  const { channels, losses } = info(file("foreign.mcap"));
  for (const { topic, messages } of channels) assert.ok(messages >= 5, `${topic}: ${messages}`);
  const { reader } = await readIndexed(file("foreign.mcap"));
  const encodings = Object.fromEntries([...reader.channelsById.values()].map(({ topic, schemaId }) => [topic, reader.schemasById.get(schemaId)?.encoding]));
  assert.deepEqual(encodings, {
    "/foreign/plain": "omgidl", "/foreign/report": "omgidl", "/foreign/settings": "omgidl", "/foreign/keyed": "omgidl",
    "/io/state": encodings["/io/state"], "/foreign/bare": undefined,
  });
  const state = [...reader.schemasById.values()].find(({ name }) => name === "galilean_msgs/msg/RobotState");
  assert.match(new TextDecoder().decode(state.data), /charge/, "not its own definition, but that of this release");
  assert.match(recorder.text, /'\/foreign\/bare' is recorded as bytes that no reader can decode: .*publishes no type information/);
  for (const { topic, not_received } of losses.writers) assert.equal(not_received, topic === "/foreign/keyed" ? null : 0, topic);
});

test("what cannot be asked for is refused, with what to write", () => {
  const cases = [
    [["--duration", "nan"], /--duration: the value must be above 0, and not 'nan'/],
    [["--duration", "0"], /--duration: the value must be above 0, and not '0'/],
    [["--duration", "inf"], /--duration: the value must be above 0/],
    [["--topics", "("], /--topics: '\(' is not a valid regular expression/],
    [["--split-size", "much"], /--split-size: 'much' is no size: write a number and a unit/],
    [["--max-files", "2"], /--max-files needs --split-size or --split-duration/],
    [["--compression", "best"], /--compression/],
    [["--topics", ""], /--topics: the value is empty; give one, or leave the option out/],
    [["--exclude", "a", ""], /--exclude: the value is empty/],
    [["--split-size", "0"], /--split-size: the value must be above 0, and not '0'/],
    [["--split-duration", "0"], /--split-duration: the value must be above 0/],
    [["--keep-memory", "0", "--on", "it is healthy"], /--keep-memory: the value must be above 0/],
    [["--keep-last", "5s"], /--keep-last needs --on, which says around what event is recorded/],
    [["--keep-after", "5s"], /--keep-after needs --on/],
    [["--keep-memory", "5MB"], /--keep-memory needs --on/],
    [["--inputs", "--exclude", "inputs"], /--exclude leaves out what --inputs asks for/],
    [["--no-images", "--pictures", "camera"], /--no-images is the same as --pictures none/],
    [["--about", "seed=7", "seed=8"], /--about: 'seed' is told twice; choose one of its values/],
    [["--about", "version=9"], /--about: the recorder itself tells 'version'; choose another word/],
    [["--on", 'state is "a'], /--on: .* is no condition: /],
  ];
  for (const [options, reason] of cases) {
    const { status, stderr } = recorded("--out", file("refused.mcap"), ...options);
    assert.equal(status, 2, options.join(" "));
    assert.match(stderr.toString(), reason);
  }
  const room = recorded("--out", "-", "--min-free", "1GB");
  assert.equal(room.status, 2);
  assert.match(room.stderr.toString(), /--min-free looks at the disk of a file/);
  const split = recorded("--out", "-", "--split-size", "1MB");
  assert.equal(split.status, 2);
  assert.match(split.stderr.toString(), /standard output cannot be split/);
  assert.equal(readdirSync(folder).includes("refused.mcap"), false);
  const replayed = spawnSync(program("galilean-replay"), ["x.mcap", "--from", "nan"], limit);
  assert.equal(replayed.status, 2);
  assert.match(replayed.stderr.toString(), /--from: the value must be at least 0, and not 'nan'/);
});
