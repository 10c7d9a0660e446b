// SPDX-License-Identifier: BSD-3-Clause
// How a running robot comes by another program: from a file that is saved, and from whom it accepts one.
import assert from 'node:assert/strict';
import { renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Running, freshDomain, galilean, scratchFolder } from './tools.mjs';

const withState = (name) => `state: name: "${name}" end\n`;

/** A robot without a board and a camera, which changes nothing about how it takes a program. */
async function startRobot(t, options) {
  const domain = freshDomain();
  const robot = new Running(t, ['robot', '--serial', '/dev/null/none', '--camera', 'shm:none', ...options], { domain });
  await robot.line(/comm_port/);
  return { robot, domain };
}

test('a robot swaps whenever the file that it watches is saved', { timeout: 60_000 }, async (t) => {
  const file = join(scratchFolder(t), 'my.bhdl');
  writeFileSync(file, withState('first'));
  const { robot } = await startRobot(t, ['--bhdl', file, '--watch']);
  writeFileSync(file, withState('second'));
  await robot.line(/first -> second \(program swapped\)/);
  writeFileSync(file, 'state: nmae: "third" end\n');
  await robot.line(/my\.bhdl:1:8: error: /);
  writeFileSync(`${file}~`, withState('third'));
  renameSync(`${file}~`, file);
  await robot.line(/second -> third \(program swapped\)/);
  assert.deepEqual(await robot.stop(), { code: 0, signal: null });
  assert.match(robot.output, /stopped/);
});

test('a program that changes its state more often than --max-transitions allows is rolled back', { timeout: 60_000 }, async (t) => {
  const file = join(scratchFolder(t), 'my.bhdl');
  writeFileSync(file, withState('still'));
  const { robot } = await startRobot(t, ['--bhdl', file, '--watch', '--max-transitions', '3']);
  const leaves = (name, to) => `state: name: "${name}" condition: bits_variable: "always" bit_index: 0 bit_value: 1 new_state: "${to}" end end\n`;
  writeFileSync(file, `variables: bits: name: "always" value: 1 status: "valid" end end\n${leaves('here', 'there')}${leaves('there', 'here')}`);
  await robot.line(/rolled back to my\.bhdl \(\w+\): it changed its state more than 3 times within a second/);
});

test('a robot takes programs over DDS only from those that it was told to', { timeout: 60_000 }, async (t) => {
  const folder = scratchFolder(t);
  const file = join(folder, 'first.bhdl');
  const pushed = join(folder, 'second.bhdl');
  writeFileSync(file, withState('first'));
  writeFileSync(pushed, withState('second'));
  const direct = galilean(['swap', '--help']).stdout.includes('--direct') ? ['--direct'] : [];
  const swap = (domain) => galilean(['swap', pushed, '--robot', 'io', ...direct], { domain });

  await t.test('by default, from the monitor', async (inner) => {
    const { robot, domain } = await startRobot(inner, ['--bhdl', file]);
    const refused = swap(domain);
    assert.equal(refused.status, 1, refused.stderr);
    assert.match(refused.stdout, /rejected.*'swap'.*--accept-swaps-from/);
    await robot.line(/rejected: it came from 'swap'/);
  });

  await t.test('or from those that are named', async (inner) => {
    const { robot, domain } = await startRobot(inner, ['--bhdl', file, '--accept-swaps-from', 'monitor,swap']);
    const taken = swap(domain);
    assert.equal(taken.status, 0, taken.stderr);
    await robot.line(/first -> second \(program swapped\)/);
  });
});

test('a program for another serial line is refused, pushed or saved, and the robot runs on', { timeout: 60_000 }, async (t) => {
  const folder = scratchFolder(t);
  const [file, pushed] = ['first.bhdl', 'second.bhdl'].map((name) => join(folder, name));
  const on = (line, state) => `input_devices: comm_port: device: "${join(folder, line)}" end end\n${withState(state)}`;
  writeFileSync(file, on('a.serial', 'first'));
  writeFileSync(pushed, on('b.serial', 'second'));
  const domain = freshDomain();
  const robot = new Running(t, ['robot', '--bhdl', file, '--watch', '--camera', 'shm:none', '--accept-swaps-from', 'swap'], { domain });
  await robot.line(/comm_port/);
  const refused = galilean(['swap', pushed, '--robot', 'io', '--direct'], { domain });
  assert.equal(refused.status, 1, refused.stderr);
  assert.match(refused.stdout, /rejected.*comm_port is '[^']*b\.serial' in this program, and this robot runs on '[^']*a\.serial'.*restart/);
  writeFileSync(file, on('b.serial', 'third'));
  await robot.line(/was saved, but cannot run: comm_port is '[^']*b\.serial'/);
  writeFileSync(file, on('a.serial', 'fourth'));
  await robot.line(/first -> fourth \(program swapped\)/);
});
