// SPDX-License-Identifier: BSD-3-Clause
// galilean-top as a person and as a script see it: on a real terminal (tmux's), and --once.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { after, before, describe, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { freshDomain } from "../tools/domain.mjs";
import { domain, limit, program, start, testTool } from "./tools.mjs";

const session = `galilean-top-${process.pid}`;
const tmux = (...words) => execFileSync("tmux", ["-L", session, ...words], { ...limit, env: { ...process.env, LC_ALL: "C.UTF-8" } }).toString();
const screen = () => tmux("capture-pane", "-p", "-t", session);

async function shows(pattern) {
  for (let i = 0; i < 500; ++i) {
    if (pattern.test(screen())) return;
    await sleep(20);
  }
  assert.match(screen(), pattern);
}

describe("galilean-top", () => {
  const talkers = [];
  before(() => {
    for (const name of ["ganymede", "io"]) talkers.push(start(testTool("wire_talker"), [name, domain]));
  });
  after(async () => {
    spawnSync("tmux", ["-L", session, "kill-server"], limit);
    for (const talker of talkers) {
      talker.stdin.end();
      await talker.ended;
    }
  });

  test("--once prints the team for scripts", () => {
    const once = spawnSync(program("galilean-top"), ["--once", "--robot", "io", "--domain", domain], limit);
    const text = once.stdout.toString();
    assert.equal(once.status, 0, once.stderr.toString());
    assert.match(text, /2 robots/);
    assert.match(text, /G ganymede +(talk|breathe) /);
    assert.match(text, /▶ I io +(talk|breathe) .* talk +3f2a91c0/);
    assert.match(text, /bumpers +█+·* +\d+% +·1······/);
    assert.match(text, /io's own frame \(no monitor\)/);
    assert.doesNotMatch(text, /\x1b/);
  });

  test("--once where nobody is heard says so after three seconds", () => {
    const once = spawnSync(program("galilean-top"), ["--once", "--domain", freshDomain()], limit);
    assert.equal(once.status, 1);
    assert.match(once.stdout.toString(), /No robot has been heard/);
  });

  test("is drawn on 80 × 24, obeys keys, follows the window, and gives the terminal back", async () => {
    tmux("-f", "/dev/null", "new-session", "-d", "-s", session, "-x", "80", "-y", "24", "sh");
    tmux("send-keys", "-t", session, `echo before; '${program("galilean-top")}' --domain ${domain}; echo code $?`, "Enter");
    await shows(/2 robots[^]*▶ G ganymede[^]*STATES[^]*VARIABLES[^]*bumpers[^]*q quit/);
    tmux("send-keys", "-t", session, "Down");
    await shows(/▶ I io/);
    tmux("send-keys", "-t", session, "1");
    await shows(/▶ G ganymede/);
    tmux("send-keys", "-t", session, "?");
    await shows(/Any key: back/);
    tmux("send-keys", "-t", session, "x", "h");
    await shows(/told ganymede to hold/);
    tmux("resize-window", "-t", session, "-x", "130", "-y", "40");
    await shows(/[^\n]{90,}/);
    tmux("send-keys", "-t", session, "q");
    await shows(/before[^]*code 0/);
    assert.doesNotMatch(screen(), /ganymede +(talk|breathe)/);
  });

  test("gives the terminal back when it is ended by a signal", async () => {
    const run = `clear; sh -c 'echo pid $$; sleep 0.3; exec "${program("galilean-top")}" --domain ${domain}'; echo code $?`;
    tmux("send-keys", "-t", session, run, "Enter");
    await shows(/^pid \d+/m);
    const pid = Number(/^pid (\d+)/m.exec(screen())[1]);
    await shows(/▶ G ganymede/);
    process.kill(pid, "SIGTERM");
    await shows(/code 0/);
    tmux("send-keys", "-t", session, "echo still'-'here", "Enter");
    await shows(/still-here/);
  });

  test("refuses to draw where there is no terminal", () => {
    const ended = spawnSync(program("galilean-top"), ["--domain", domain], limit);
    assert.equal(ended.status, 1);
    assert.match(ended.stderr.toString(), /not a terminal.*--once/);
  });
});
