// SPDX-License-Identifier: BSD-3-Clause
// Whatever reads a file refuses a pipe, a socket, a device and a folder in a sentence that says so, and waits for nobody.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { domain, program } from "./tools.mjs";

const folder = mkdtempSync(path.join(tmpdir(), "galilean-no-files-"));
const file = (name) => path.join(folder, name);
const KINDS = { pipe: file("pipe"), socket: file("socket"), folder: file("folder"), device: "/dev/zero" };
const SHIPPED = fileURLToPath(new URL("../../bhdl/programs/sit_and_spin.bhdl", import.meta.url));
/** Long for a program that refuses its file, and short for one that waits for ever. */
const REFUSES_WITHIN_MS = 20_000;

const log = (...words) => ["galilean-log", ...words];
/** What each verb is called with in place of a file. */
const VERBS = [
  (it) => log("info", it),
  (it) => log("cat", it),
  (it) => log("csv", it, "io/state"),
  (it) => log("stats", it),
  (it) => log("plot", it, "io/state.x_m"),
  (it) => log("verify", it),
  (it) => log("diff", it, it),
  (it) => log("coverage", it),
  (it) => log("rerun", it),
  ...["slice", "merge", "recover", "convert"].map((verb) => (it) => log(verb, it, "--out", file("out.mcap"))),
  (it) => ["galilean-log-check", it, "--expect", file("right.expect")],
  (it) => ["galilean-log-check", "--syntax", "--expect", it],
  (it) => ["galilean-replay", it],
  (it) => ["galilean-bhdl", "check", it],
  (it) => ["galilean-bhdl", "check", SHIPPED, "--catalog", it],
  (it) => ["galilean-bhdl", "fmt", it],
  (it) => ["galilean-bhdl-test", it],
  (it) => ["galilean-swap", it, "--team"],
  (it) => ["galilean-swap", SHIPPED, "--team", "--token-file", it],
  (it) => ["galilean-robot", "--name", "io", "--bhdl", it],
  (it) => ["galilean-sim", "--headless", "--scenario", it],
  (it) => ["galilean-sim", "--headless", "--duration", "1", "--start", it],
];

describe("what is no file", () => {
  const server = createServer();
  before(async () => {
    execFileSync("mkfifo", [KINDS.pipe]);
    mkdirSync(KINDS.folder);
    writeFileSync(file("right.expect"), "every robot: always it is healthy\n");
    await new Promise((resolve) => server.listen(KINDS.socket, resolve));
  });
  after(() => {
    server.close();
    rmSync(folder, { recursive: true });
  });

  test("a pipe that nobody reads is not recorded to, and nothing waits for its reader for ever", () => {
    const { status, stderr } = spawnSync(program("galilean-record"), ["--out", KINDS.pipe, "--domain", domain], { encoding: "utf8", timeout: REFUSES_WITHIN_MS, killSignal: "SIGKILL" });
    assert.equal(status, 1, stderr);
    assert.match(stderr, /pipe is a pipe that nobody reads; start its reader first/);
  });

  for (const verb of VERBS)
    for (const [kind, it] of Object.entries(KINDS)) {
      const [name, ...words] = verb(it);
      test(`${name} ${words[0]}: a ${kind} is refused`, () => {
        const { status, signal, error, stdout, stderr } = spawnSync(program(name), words, { encoding: "utf8", timeout: REFUSES_WITHIN_MS, killSignal: "SIGKILL" });
        const said = stdout + stderr;
        assert.equal(error, undefined, `${words.join(" ")}: ${said}`);
        assert.equal(signal, null, said);
        assert.notEqual(status, 0, said);
        assert.ok(said.includes(it), said);
        if (name !== "galilean-sim" || words.includes("--start")) assert.match(said, new RegExp(`is a ${kind}, and no file`));
      });
    }
});
