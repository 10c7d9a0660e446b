// SPDX-License-Identifier: BSD-3-Clause
// A robot program that died is started again: what it runs, and that it moves nothing unasked.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { eventually, freshDomain, galilean, Running, scratchFolder } from './tools.mjs';

const DIED = 'held: the robot program died while the robot was running, and was started again; resume it, or push a bumper.';

/** A folder with two programs, and what one does with a robot without a board and a camera. */
function stage(t) {
  const domain = freshDomain();
  const cwd = scratchFolder(t), env = { XDG_STATE_HOME: join(cwd, 'state') };
  const kept = join(cwd, `state/galilean/robots/domain_${domain}/io.json`);
  for (const name of ['first', 'second']) writeFileSync(join(cwd, `${name}.bhdl`), `state: name: "${name}" end\n`);
  const read = () => JSON.parse(readFileSync(kept, 'utf8'));
  const newest = () => JSON.parse(galilean(['echo', 'io/state', '--count', '1', '--json'], { domain }).stdout);
  return {
    kept, read, newest,
    start: async (...options) => {
      const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', 'first.bhdl', '--serial', '/dev/null/none', '--camera', 'shm:none',
        '--probation', '1', '--accept-swaps-from', 'any', ...options], { domain, cwd, env });
      await robot.line(/comm_port/);
      return robot;
    },
    /** Brings the second program to the robot, until that has proven itself and is kept. */
    push: async () => {
      const { status, stdout, stderr } = galilean(['swap', 'second.bhdl', '--robot', 'io', '--direct'], { domain, cwd });
      assert.equal(status, 0, stdout + stderr);
      await eventually(() => read().pushed);
    },
    resume: () => galilean(['resume', '--robot', 'io'], { domain }),
    order: (verb) => {
      const { status, stdout, stderr } = galilean([verb, '--robot', 'io'], { domain });
      assert.equal(status, 0, stdout + stderr);
    },
  };
}

async function die(robot) {
  robot.process.kill('SIGKILL');
  assert.deepEqual(await robot.exited, { code: null, signal: 'SIGKILL' });
}

test('after a kill the robot is held with the program that was pushed, and after an orderly end it is not', { timeout: 180_000 }, async (t) => {
  const { read, newest, start, push, resume } = stage(t);
  const first = await start();
  assert.deepEqual([read().running, read().pushed, read().files[0].path], [true, false, 'first.bhdl']);
  assert.deepEqual([newest().held, newest().program_name], [false, 'first.bhdl']);
  await push();
  await die(first);

  const again = await start();
  assert.match(again.output, /the robot program died while it ran second\.bhdl \(\w{8}\), which was pushed and confirmed last: it runs that again, and not first\.bhdl \(\w{8}\) of --bhdl; begin with --fresh to run that/);
  const held = newest();
  assert.deepEqual([held.held, held.program_name], [true, 'second.bhdl']);
  assert.ok(held.problems.includes(DIED), JSON.stringify(held.problems));
  const resumed = resume();
  assert.equal(resumed.status, 0, resumed.stdout + resumed.stderr);
  await eventually(() => !newest().held && !newest().problems.includes(DIED));
  assert.deepEqual(await again.stop(), { code: 0, signal: null });
  assert.equal(read().running, false);

  const orderly = await start();
  assert.match(orderly.output, /it runs first\.bhdl \(\w{8}\) of --bhdl, and not second\.bhdl \(\w{8}\), which somebody had pushed/);
  assert.deepEqual([newest().held, newest().program_name], [false, 'first.bhdl']);
});

test('--fresh begins with the program that is given, and --resume-by-itself holds nobody', { timeout: 180_000 }, async (t) => {
  const { newest, start, push } = stage(t);
  const first = await start();
  await push();
  await die(first);
  const fresh = await start('--fresh', '--resume-by-itself');
  assert.match(fresh.output, /it runs first\.bhdl \(\w{8}\) of --bhdl, since --fresh says so/);
  assert.deepEqual([newest().held, newest().program_name], [false, 'first.bhdl']);
});

test('who was held or taken out of service stays so after a crash, also where faults hold nobody', { timeout: 180_000 }, async (t) => {
  const { read, newest, start, order, resume } = stage(t);
  const first = await start('--resume-by-itself');
  order('hold');
  order('decommission');
  await eventually(() => read().held_by !== '' && read().out_of_service);
  const { held_by: holder } = read();
  await die(first);

  const again = await start('--resume-by-itself');
  const sentence = `held: ${holder} held it when the robot program died and was started again; resume it.`;
  await eventually(() => newest().problems.includes(sentence));
  assert.deepEqual([newest().held, newest().out_of_service], [true, true]);
  await die(again);

  const third = await start('--resume-by-itself');
  await eventually(() => newest().problems.includes(sentence));
  assert.deepEqual([newest().held, newest().out_of_service], [true, true], 'a second crash ends it no more than the first');
  order('commission');
  const resumed = resume();
  assert.equal(resumed.status, 0, resumed.stdout + resumed.stderr);
  await eventually(() => !newest().held && !newest().problems.includes(sentence) && !newest().out_of_service);
  await eventually(() => read().held_by === '' && !read().out_of_service);
  await die(third);
  await start('--resume-by-itself');
  assert.deepEqual([newest().held, newest().out_of_service], [false, false]);
});

test('a file that is cut short or foreign is told of in one sentence, and written anew', { timeout: 180_000 }, async (t) => {
  const { kept, read, newest, start } = stage(t);
  mkdirSync(dirname(kept), { recursive: true });
  for (const text of ['', '{"format":"galilean robot, version 1","robot":"i', '<html></html>\n', '{}']) {
    writeFileSync(kept, text);
    const robot = await start();
    assert.equal(robot.output.match(/io\.json is not what this robot kept: /g)?.length, 1, robot.output);
    assert.deepEqual([newest().held, newest().program_name], [true, 'first.bhdl']);
    assert.equal(read().running, true);
    assert.deepEqual(await robot.stop(), { code: 0, signal: null });
  }
});

test('--keep-nothing neither reads nor writes', { timeout: 60_000 }, async (t) => {
  const { kept, start } = stage(t);
  mkdirSync(dirname(kept), { recursive: true });
  writeFileSync(kept, 'of somebody else');
  const robot = await start('--keep-nothing');
  assert.deepEqual(await robot.stop(), { code: 0, signal: null });
  assert.equal(readFileSync(kept, 'utf8'), 'of somebody else');
  assert.doesNotMatch(robot.output, /io\.json/);
});
