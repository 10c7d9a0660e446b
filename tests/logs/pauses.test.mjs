// SPDX-License-Identifier: BSD-3-Clause
// A recording that is paused and goes on: by command and by key. What was not recorded is told, and is no loss.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { freshDomain } from "../tools/domain.mjs";
import { eventually } from "../tools/patience.mjs";
import { endsWell, info, limit, program, readIndexed, start, testTool } from "./tools.mjs";

const folder = mkdtempSync(path.join(tmpdir(), "galilean-pauses-"));
const file = (name) => path.join(folder, name);
const domain = freshDomain();
const grown = (name, size) => eventually(() => statSync(file(name), { throwIfNoEntry: false })?.size > size);
const order = (...args) => spawnSync(program("galilean-record-ctl"), [...args, "--domain", domain], { ...limit, env: { ...process.env, USER: "anna" } });

let talker;
before(() => (talker = start(testTool("wire_talker"), ["io", domain])));
after(async () => {
  talker.stdin.end();
  await talker.ended;
  rmSync(folder, { recursive: true });
});

test("a pause by command is in the file from its beginning to its end, and nothing of it counts as lost", async () => {
  const recorder = start(program("galilean-record"), ["--out", file("run.mcap"), "--domain", domain, "--about", "seed=7"]);
  await grown("run.mcap", 20_000);
  const paused = order("pause");
  assert.equal(paused.status, 0, paused.stderr.toString());
  assert.match(paused.stdout.toString(), /^run is paused since \d{4}-\d\d-\d\dT[\d:.]+Z\n$/);
  assert.match(order("pause", "--name", "run").stdout.toString(), /^run was paused since .* already\n$/);
  await sleep(1500);
  const resumed = order("resume", "--name", "run");
  assert.match(resumed.stdout.toString(), /^run records again; it was paused since .*Z\n$/, resumed.stderr.toString());
  assert.match(order("resume").stdout.toString(), /^run was not paused, and records\n$/);
  const size = statSync(file("run.mcap")).size;
  await grown("run.mcap", size + 20_000);
  recorder.kill("SIGINT");
  await endsWell(recorder);
  assert.match(recorder.text, /galilean-record: paused by anna from .* on; 'galilean record resume' goes on\n/);
  assert.match(recorder.text, /galilean-record: goes on; paused by anna from .* to .*, \d+ messages not recorded\n/);

  const told = info(file("run.mcap"));
  assert.equal(told.pauses.length, 1);
  const [pause] = told.pauses;
  assert.equal(pause.by, "anna");
  assert.ok(pause.messages > 100, `${pause.messages} messages in 1.5 s`);
  const { messages } = await readIndexed(file("run.mcap"));
  const within = messages.filter(({ topic, logTime }) => topic.startsWith("/io/") && logTime > BigInt(pause.from_ns) && logTime < BigInt(pause.to_ns));
  assert.deepEqual(within.map(({ topic }) => topic), []);
  const states = messages.filter(({ topic }) => topic === "/io/state").map(({ sequence }) => sequence);
  const skipped = states.at(-1) - states[0] + 1 - states.length;
  const state = told.losses.writers.find(({ topic }) => topic === "/io/state");
  // The newest state of the pause is recorded at its end, though it came in it.
  assert.equal(state.paused - 1 + state.not_received, skipped);
  assert.ok(state.not_received < skipped / 2, `${state.not_received} lost`);
  assert.equal(told.metadata.galilean.seed, "7");
  assert.deepEqual(told.metadata_records.filter(({ name }) => name === "program").map(({ entries: { robot, hash, name } }) => ({ robot, hash, name })), [{ robot: "io", hash: "3f2a91c0", name: "talk" }]);
  const text = spawnSync(program("galilean-log"), ["info", file("run.mcap")], limit).stdout.toString();
  assert.match(text, /^pause: +paused by anna from .* to .*\(\d\.\d s\), \d+ messages not recorded$/m);
  assert.match(text, /^program: +io ran talk 3f2a91c0 from /m);
  assert.match(text, /^recorder: .*seed 7/m);

  writeFileSync(file("gaps.expect"), "every robot: rate of ~/state >= 1 Hz, no gaps longer than 500 ms\n");
  const judged = spawnSync(program("galilean-log-check"), [file("run.mcap"), "--expect", file("gaps.expect")], limit);
  assert.notEqual(judged.status, 1, `a pause is no gap of the robot's:\n${judged.stdout}${judged.stderr}`);
});

test("a recorder that is killed in a pause has told when it began", async () => {
  const recorder = start(program("galilean-record"), ["--out", file("cut.mcap"), "--domain", domain, "--name", "cut"]);
  await grown("cut.mcap", 20_000);
  assert.equal(order("pause", "--name", "cut").status, 0);
  await sleep(1500); // the chunk with the pause is written within a second
  recorder.kill("SIGKILL");
  await recorder.ended;
  const told = info(file("cut.mcap"), 3);
  assert.deepEqual(told.pauses.map(({ to, by }) => ({ to, by })), [{ to: null, by: "anna" }]);
});

test("space pauses and goes on, and q ends, in a recorder's terminal", async () => {
  const command = `'${program("galilean-record")}' --out '${file("keys.mcap")}' --domain ${domain} --name keys`;
  const terminal = spawn("script", ["-qefc", command, "/dev/null"], { env: { ...process.env, SHELL: "/bin/bash", USER: "bert" } });
  let text = "";
  terminal.stdout.on("data", (data) => (text += data));
  const closed = new Promise((resolve) => terminal.on("close", resolve));
  await eventually(() => text.includes("keys: space pauses and goes on, q ends"));
  await grown("keys.mcap", 20_000);
  terminal.stdin.write(" ");
  await eventually(() => /paused by bert from .* on; space or 'galilean record resume' goes on/.test(text));
  terminal.stdin.write(" ");
  await eventually(() => /goes on; paused by bert/.test(text));
  terminal.stdin.write("q");
  assert.ok([0, 3].includes(await closed), text);
  const told = info(file("keys.mcap"));
  assert.equal(told.recovered, false);
  assert.equal(told.pauses.length, 1);
});

test("who is not there cannot be paused, and the answer says who is", async () => {
  const nameless = spawnSync(program("galilean-record-ctl"), ["pause", "--name", "", "--domain", freshDomain()], limit);
  assert.equal(nameless.status, 2);
  assert.match(nameless.stderr.toString(), /--name: the value is empty/);
  const nobody = spawnSync(program("galilean-record-ctl"), ["pause", "--domain", freshDomain()], limit);
  assert.equal(nobody.status, 1);
  assert.match(nobody.stderr.toString(), /^galilean record pause: no recorder is heard; check that galilean record runs in the same DDS domain/);
  const recorders = ["one", "two"].map((name) => start(program("galilean-record"), ["--out", file(`${name}.mcap`), "--domain", domain]));
  for (const name of ["one", "two"]) await grown(`${name}.mcap`, 10_000);
  const unnamed = order("pause");
  assert.equal(unnamed.status, 1);
  assert.match(unnamed.stderr.toString(), /several recorders are heard; choose one of them with --name: .*one.*two/);
  assert.match(order("pause", "--name", "three").stderr.toString(), /the recorder 'three' is not heard; heard are .*one.*two/);
  for (const recorder of recorders) recorder.kill("SIGINT");
  for (const recorder of recorders) await endsWell(recorder);
});
