// SPDX-License-Identifier: BSD-3-Clause
// Programs whose output nobody reads any more, as behind `… | head -1`: those that do more than print go on.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { eventually, freshDomain, galilean, galileanBinary, getJson, programs, Running, scratchFolder } from './tools.mjs';

const limit = { timeout: 120_000 };
const ended = { code: 0, signal: null };

/** As the monitor there knows it; undefined as long as there is no monitor or no such robot. */
async function io(port) {
  const { robots } = await getJson(`http://127.0.0.1:${port}/api/status`).catch(() => ({ robots: [] }));
  return robots.find((robot) => robot.name === 'io' && !robot.silent);
}
const travelled = (from, to) => Math.hypot(to.x_m - from.x_m, to.y_m - from.y_m);

test('a team drives, is recorded and played again when nobody reads what its programs print', limit, async (t) => {
  const domain = freshDomain();
  const cwd = scratchFolder(t);
  const port = 18900 + Number(domain) % 60;
  const start = (...args) => new Running(t, args, { domain, cwd, env: { XDG_RUNTIME_DIR: cwd }, unheard: true });

  const sim = start('sim', '--live', '--scenario', 'office', '--robots', '1', '--run', `unheard-${domain}`, '--autostart', '0.5');
  const robot = start('robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`,
    '--serial', `${cwd}/galilean-unheard-${domain}/io.serial`, '--camera', `shm:galilean-unheard-${domain}-io`);
  const monitor = start('monitor', '--listen', `127.0.0.1:${port}`, '--data', cwd);
  const recorder = start('record', '--out', 'run.mcap', '--no-images');

  const first = await eventually(async () => {
    const now = await io(port);
    return now && now.problems.length === 0 && now.state !== 'start' && now;
  });
  for (const [order, held] of [['hold', true], ['resume', false], ['hold', true], ['resume', false]]) {
    const told = galilean([order, '--team'], { domain });
    assert.equal(told.status, 0, told.stderr);
    await eventually(async () => (await io(port)).held === held);
  }
  const last = await eventually(async () => {
    const now = await io(port);
    return travelled(first, now) > 0.3 && now;
  });
  assert.ok(last.tick > first.tick);

  for (const program of [robot, sim]) assert.deepEqual(await program.stop(), ended, program.process.spawnargs.join(' '));
  const recorded = await recorder.stop();
  assert.deepEqual(await monitor.stop(), ended);
  const info = galilean(['log', 'info', 'run.mcap', '--json'], { cwd });
  assert.deepEqual(recorded, { code: JSON.parse(info.stdout).losses.missing > 0 ? 3 : 0, signal: null });
  assert.ok(JSON.parse(info.stdout).channels.some(({ topic }) => topic === '/io/state'), info.stderr);
  assert.deepEqual(await start('replay', 'run.mcap', '--rate', '20').exited, ended);
});

test('a demo whose output nobody reads goes on until it is ended', limit, async (t) => {
  const domain = freshDomain();
  const port = 18900 + Number(domain) % 60;
  const demo = new Running(t, ['demo', '--robots', '1', '--port', String(port)], { domain, cwd: scratchFolder(t), unheard: true });
  await eventually(async () => {
    const now = await io(port);
    return now && now.state !== 'start';
  });
  assert.deepEqual(await demo.stop(), ended);
});

test('what cannot be printed is told in one sentence, whatever the program', limit, async (t) => {
  const cwd = scratchFolder(t);
  const verbs = galilean(['help']).stdout.matchAll(/^ {2}(?:galilean )?([a-z]+)\b/gm);
  const asked = [['help'], ['version'], ['bhdl', 'describe'], ...[...new Set([...verbs].map(([, verb]) => verb))].map((verb) => [verb, '--help'])];
  assert.ok(asked.length > 15, `${asked.length} verbs`);
  for (const args of asked)
    for (const where of ['> /dev/full', '>&-']) {
      const run = spawnSync('sh', ['-c', `exec "$0" "$@" ${where}`, galileanBinary, ...args], { cwd, encoding: 'utf8' });
      const what = `galilean ${args.join(' ')} ${where}: ${run.stderr}`;
      assert.equal(run.status, 1, what);
      assert.match(run.stderr, /^galilean[a-z-]*: standard output cannot be written: [^\n]+\n$/, what);
    }
});

test('a command that only prints ends quietly', limit, async (t) => {
  const command = new Running(t, ['bhdl', 'describe'], { unheard: true });
  assert.deepEqual(await command.exited, { code: null, signal: 'SIGPIPE' });
  assert.equal(command.output, '');
});
