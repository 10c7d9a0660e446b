// SPDX-License-Identifier: BSD-3-Clause
// Robots of separate processes, recorded with what their ticks read, run again: no bit differs.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { setTimeout as sleep } from 'node:timers/promises';
import { after, before, describe, test } from 'node:test';
import { eventually, freePort, freshDomain, galilean, getJson, programs, Running, scratchFolder } from './tools.mjs';

// Longer than it takes until robots tell again what they remember.
const RECORDED_S = 15;
// Longer than what writers of inputs keep for who comes late.
const UNHEARD_S = 4;

describe('a team that is recorded with --inputs from its start', () => {
  const leaving = [];
  const all = { after: (leave) => leaving.push(leave) };
  const leaveAll = async () => { for (const leave of leaving.splice(0)) await leave(); };
  after(leaveAll);
  const cwd = scratchFolder(all);
  const rerun = (...args) => galilean(['log', 'rerun', ...args], { cwd });

  // Where it fails, nobody calls `after`: what it has started would keep this process from its end.
  before(() => recordTeam().catch((error) => leaveAll().finally(() => { throw error; })));

  async function recordTeam() {
    const domain = freshDomain();
    const record = (name, ...options) => new Running(all, ['record', '--out', name, '--pictures', 'none', ...options], { domain, cwd });
    const recorder = record('run.mcap', '--inputs');
    await eventually(() => existsSync(`${cwd}/run.mcap`));
    const port = await freePort();
    const team = new Running(all, ['demo', '--port', String(port), '--seed', '1'], { domain, cwd });
    await team.line(/http:\/\/127\.0\.0\.1:\d+\S*\n/);
    await eventually(async () => (await getJson(`http://127.0.0.1:${port}/api/status`)).robots.length === 3);
    await sleep(UNHEARD_S * 1000);
    const late = record('late.mcap', '--inputs');
    const without = record('without.mcap');
    for (const command of [['start'], ['hold', '--team'], ['resume', '--team'], ['step', 'io']]) {
      await sleep(RECORDED_S * 1000 / 5);
      galilean(command, { domain, cwd });
    }
    galilean(['resume', '--team'], { domain, cwd });
    await sleep(RECORDED_S * 1000 / 5);
    await team.stop();
    await Promise.all([recorder, late, without].map((each) => each.stop()));
  }

  test('runs again without a bit that differs', () => {
    const { status, stdout, stderr } = rerun('run.mcap', '--json');
    assert.equal(status, 0, stdout + stderr);
    const runs = stdout.trim().split('\n').map((line) => JSON.parse(line));
    assert.deepEqual(runs.map(({ robot }) => robot), ['callisto', 'ganymede', 'io']);
    for (const run of runs) {
      assert.equal(run.same, true);
      assert.ok(run.ticks > 10 * RECORDED_S, `${run.robot}: ${run.ticks} ticks`);
    }
  });

  test('is told of in words, for the robots that are asked for', () => {
    const { status, stdout } = rerun('run.mcap', '--robot', 'io');
    assert.equal(status, 0);
    assert.match(stdout, /^run\.mcap \/io\/inputs: 0 bits differ in \d+ ticks \(\d+\.\d s run again in .* x real time\)\n$/);
  });

  test('goes another way with another program, and says where and why', () => {
    const { status, stdout } = rerun('run.mcap', '--robot', 'io', '--bhdl', `${programs}/wander.bhdl`);
    assert.equal(status, 1, stdout);
    assert.match(stdout, /differs first in tick \d+, at .* s with the other program\n {2}cause: /);
  });

  test('runs again from its middle, too, where the recorder came late', () => {
    const { status, stdout } = rerun('late.mcap');
    assert.equal(status, 0, stdout);
    assert.match(stdout, /^late\.mcap \/io\/inputs: 0 bits differ in \d+ ticks from tick \d+ on, \d+ left out/m);
  });

  test('names the robots whose inputs there are, where another is asked for', () => {
    const nobody = rerun('run.mcap', '--robot', 'io', 'nobody');
    assert.deepEqual([nobody.status, nobody.stdout], [1, '']);
    assert.equal(nobody.stderr, "galilean log rerun: no inputs of a robot 'nobody' are recorded; there are those of callisto, ganymede and io\n");
    assert.match(rerun('run.mcap', '--robot', 'ganymed').stderr, /did you mean 'ganymede'\?/);
  });

  test('is not begun where the other program cannot be read, which is said once', () => {
    const { status, stdout, stderr } = rerun('run.mcap', '--bhdl', 'none.bhdl');
    assert.deepEqual([status, stdout], [1, '']);
    assert.match(stderr, /^[^\n]*none\.bhdl[^\n]*\n$/);
  });

  test('needs --inputs: nobody else makes robots send them', () => {
    const { status, stderr } = rerun('without.mcap');
    assert.equal(status, 1);
    assert.match(stderr, /record --inputs/);
  });

  test('is damaged where a byte of the file is: nothing is called the same from there on', () => {
    const bytes = readFileSync(`${cwd}/run.mcap`);
    bytes[Math.floor(bytes.length / 2)] ^= 1;
    writeFileSync(`${cwd}/flipped.mcap`, bytes);
    const { status, stdout, stderr } = rerun('flipped.mcap');
    assert.equal(status, 3, stdout + stderr);
    assert.match(stdout, /cannot tell from tick \d+: the inputs of \d+ ticks? are missing/);
  });
});
