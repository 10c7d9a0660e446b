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
    const found = pattern.exec(screen());
    if (found) return found;
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
    assert.match(text, /G +ganymede +(talk|breathe) /);
    assert.match(text, /▶.?I +io +(talk|breathe) .* talk +3f2a91c0/);
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
    await shows(/2 robots[^]*▶.?G +ganymede[^]*STATES[^]*VARIABLES[^]*bumpers[^]*q quit/);
    tmux("send-keys", "-t", session, "Down");
    await shows(/▶.?I +io/);
    tmux("send-keys", "-t", session, "1");
    await shows(/▶.?G +ganymede/);
    tmux("send-keys", "-t", session, "?");
    await shows(/any other key goes back/);
    tmux("send-keys", "-t", session, "x", "h");
    await shows(/told ganymede to hold/);
    tmux("resize-window", "-t", session, "-x", "130", "-y", "40");
    await shows(/[^\n]{90,}/);
    tmux("send-keys", "-t", session, "q");
    await shows(/before[^]*code 0/);
    assert.doesNotMatch(screen(), /ganymede +(talk|breathe)/);
  });

  /** What a program can leave behind: the other screen, a hidden cursor, reports of the mouse. */
  const left = () => tmux("display-message", "-p", "-t", session, "#{alternate_on} #{cursor_flag} #{mouse_any_flag}").trim();
  const type = (...keys) => tmux("send-keys", "-t", session, ...keys);
  /** Starts it in the session's shell, which then tells the exit code and whether the terminal's mode is as before. */
  let runs = 0;
  async function run(options = "") {
    const mark = `run ${++runs}: pid`;
    type(`stty sane; clear; mode=$(stty -g); sh -c 'echo ${mark} $$; sleep 0.3; exec "${program("galilean-top")}" --domain ${domain} ${options}'; echo code $?; [ "$mode" = "$(stty -g)" ] && echo same mode`, "Enter");
    const pid = Number((await shows(new RegExp(`^${mark} (\\d+)`, "m")))[1]);
    await shows(/▶.?G +ganymede/);
    return pid;
  }
  async function isBack(code) {
    await shows(new RegExp(`code ${code}\\s+same mode`));
    assert.equal(left(), "0 1 0");
  }

  for (const [signal, code] of [["SIGTERM", 0], ["SIGINT", 0], ["SIGHUP", 0], ["SIGQUIT", 131], ["SIGABRT", 134]])
    test(`gives the terminal back when it is ended by ${signal}`, async () => {
      const pid = await run();
      assert.notEqual(left(), "0 1 0");
      process.kill(pid, signal);
      await isBack(code);
    });

  test("gives the terminal to the shell while it is stopped, and takes it again", async () => {
    await run();
    type("C-z");
    await shows(/Stopped|suspended/i);
    assert.equal(left(), "0 1 0");
    type("clear; echo in' the 'shell; stty -a | grep -o ' echo '", "Enter");
    await shows(/in the shell\s+echo/);
    type("clear; fg; echo code $?", "Enter");
    await shows(/▶.?G +ganymede[^]*q quit/);
    type("q");
    await shows(/code 0/);
    assert.equal(left(), "0 1 0");
  });

  test("ends with its terminal", async () => {
    const pid = await run();
    tmux("kill-server");
    for (let i = 0; ; ++i) {
      try {
        process.kill(pid, 0);
      } catch {
        break;
      }
      assert.ok(i < 500, "it runs on");
      await sleep(20);
    }
  });

  test("says what it needs where it cannot read keys or draw, and does not wait", () => {
    for (const stdin of ["ignore", "pipe"]) {
      const ended = spawnSync(program("galilean-top"), ["--domain", domain], { ...limit, stdio: [stdin, "pipe", "pipe"] });
      assert.equal(ended.status, 2);
      assert.match(ended.stderr.toString(), /keys are read from standard input, which is not a terminal; --once/);
      assert.equal(ended.stdout.toString(), "");
    }
    const piped = spawnSync("script", ["-qec", `'${program("galilean-top")}' --domain ${domain} | cat; echo code \${PIPESTATUS[0]}`, "/dev/null"], { ...limit, env: { ...process.env, SHELL: "/bin/bash" } });
    assert.match(piped.stdout.toString(), /drawn on standard output, which is not a terminal; --once[^]*code 2/);
    const dumb = spawnSync("script", ["-qec", `'${program("galilean-top")}' --domain ${domain}; echo code $?`, "/dev/null"], { ...limit, env: { ...process.env, TERM: "dumb" } });
    assert.match(dumb.stdout.toString(), /type 'dumb' cannot be drawn on[^]*code 2/);
  });
});
