// SPDX-License-Identifier: BSD-3-Clause
// Break points, steps and locks, with two robots in a simulation: galilean break, step and resume.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { eventually, freshDomain, galilean, Running, scratchFolder } from './tools.mjs';

/** Of BreakPoint.kind and of Breaks.stopped_by, as core/wire/idl numbers them. */
const [STOP, STOP_TEAM] = [1, 2];
const [BREAK_POINT, STEP, TEAM] = [1, 2, 3];

/** Drives slowly for a second whenever a bumper was pushed, and then rests until the next push. */
const program = `
variables:
  shaft: name: "shaft" status: "valid"
  bits: name: "bumpers"
  bits: name: "time"
  force: name: "pull"
  force: name: "sum"
end
perceptual_schemas:
  bumper_scanner: name: "scan" bits_variable: "bumpers" end
  time_detector: name: "clock" bits_variable: "time" duration: 1 end
end
motor_schemas:
  noise: name: "wander" persistence: 86400 shaft_variable: "shaft" result: "pull" end
  combine_forces: name: "combine" inputs: "pull" gains: 0.2 result: "sum" end
  move_robot: name: "move" input_force: "sum" shaft_variable: "shaft" end
end
states:
  state: name: "wait" perceptual_schemas: "scan" end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1 new_state: "go" end
  end
  state: name: "go" perceptual_schemas: "clock" end motor_schemas: "wander" "combine" "move" end
    condition: bits_variable: "time" bit_index: 0 bit_value: 1 new_state: "rest" end
  end
  state: name: "rest" perceptual_schemas: "scan" end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1 new_state: "go" end
  end
end
`;

async function startTwo(t) {
  const domain = freshDomain();
  const cwd = scratchFolder(t);
  writeFileSync(join(cwd, 'drive.bhdl'), program);
  const sim = new Running(t, ['sim', '--live', '--scenario', 'office', '--robots', '2', '--run', `breaks-${domain}`], { domain, cwd });
  const { robots } = JSON.parse((await sim.line(/^\{.*"ready".*\}$/m))[0]);
  const [io, ganymede] = ['io', 'ganymede'].map((name, i) => new Running(t, ['robot', '--name', name, '--bhdl', 'drive.bhdl',
    '--serial', robots[i].serial, '--camera', robots[i].camera, '--resume-by-itself'], { domain, cwd }));
  const run = (...args) => galilean(args, { domain, env: { USER: 'anna' } });
  const say = (...args) => {
    const { status, stdout, stderr } = run(...args);
    assert.deepEqual([status, stderr], [0, ''], stdout);
    return stdout.trim();
  };
  const newest = (topic) => JSON.parse(say('echo', topic, '--count', '1', '--json'));
  const comes = (expression) => say('wait', expression, '--timeout', '60');
  comes('io/state.tick > 5 and ganymede/state.tick > 5');
  // The board answers a little after the robot began.
  await eventually(() => newest('io/state').problems.length === 0 && newest('ganymede/state').problems.length === 0);
  return { io, ganymede, run, say, newest, comes };
}

const moved = (from, to) => Math.hypot(to.x_m - from.x_m, to.y_m - from.y_m) + Math.abs(to.heading_rad - from.heading_rad);

test('a team is stopped between states, steps on, waits at a lock and goes on', { timeout: 300_000 }, async (t) => {
  const { io, run, say, newest, comes } = await startTwo(t);

  await t.test('io stops where its state changes, says why, and its motors stand', async () => {
    assert.equal(say('break', 'wait:go', '--robot', 'io'), 'io: stops at wait -> go');
    assert.equal(say('break', '--list'), 'ganymede: has no break points\nio: stops at wait -> go');
    const before = [newest('io/state'), newest('ganymede/state')];
    say('start', '--team');
    comes('io/breaks.stopped == true');
    const told = newest('io/breaks');
    assert.deepEqual([told.stopped_by, told.break_robot, told.author, Number(told.stopped_at)], [BREAK_POINT, 'io', 'anna', 1]);
    assert.deepEqual(told.break_point, { from_state: 'wait', to_state: 'go', kind: STOP });
    await io.line(/stopped at break point wait -> go, set by anna/);
    comes('io/state.state == "rest" and ganymede/state.state == "rest"');
    const after = [newest('io/state'), newest('ganymede/state')];
    assert.deepEqual(after.map(({ held }) => held), [true, false]);
    assert.ok(moved(before[0], after[0]) < 1e-3, `io moved ${moved(before[0], after[0])}`);
    assert.ok(moved(before[1], after[1]) > 1e-2, `ganymede moved ${moved(before[1], after[1])}`);
    assert.equal(say('break', '--list', '--robot', 'io'), 'io: stops at wait -> go\nio: was stopped by break point wait -> go (anna)');
  });

  await t.test('a step lets it go on to the next change of state, and resume from there', () => {
    assert.equal(say('step', '--robot', 'io'), 'io: goes on until its next change of state');
    comes('io/state.held == false and io/breaks.stepping == true');
    assert.equal(say('start', '--robot', 'io'), 'io: rest → go');
    comes(`io/breaks.stopped_by == ${STEP} and io/state.held == true`);
    assert.equal(say('resume', '--robot', 'io'), 'io: goes on; it was stopped by a step (anna)');
    comes('io/breaks.stopped == false');
  });

  await t.test('what an operator holds does not step', () => {
    assert.equal(say('hold', '--robot', 'io'), 'io: stands still');
    const { status, stdout } = run('step', '--robot', 'io');
    assert.deepEqual([status, stdout], [1, 'io: refused: io is held by anna, not at a break point: resume it first\n']);
    assert.equal(newest('io/state').held, true);
    assert.equal(say('resume', '--robot', 'io'), 'io: goes on');
  });

  await t.test('a lock keeps it in its state until it is let through', () => {
    comes('io/state.state == "rest"');
    assert.equal(say('break', 'go:rest', '--lock', '--robot', 'io'), 'io: is locked at go -> rest');
    say('start', '--robot', 'io');
    comes('io/breaks.waits_at_from == "go" and io/breaks.waits_at_to == "rest"');
    assert.equal(newest('io/state').state, 'go');
    assert.match(say('break', '--list', '--robot', 'io'), /^io: has waited at the lock go -> rest for \d+ s$/m);
    assert.equal(say('break', '--let-through', 'go:rest', '--robot', 'io'), 'io: opens the lock once at go -> rest');
    comes('io/state.state == "rest"');
    say('start', '--robot', 'io');
    comes('io/breaks.waits_at_to == "rest"');
    assert.equal(say('break', 'go:rest', '--remove', '--robot', 'io'), 'io: no longer stops or waits at go -> rest');
    comes('io/state.state == "rest" and io/breaks.waits_at_to == ""');
  });

  await t.test('a break point of one stops the team, and each steps on from there', () => {
    assert.equal(say('break', 'rest', '--stop-team', '--robot', 'io'), 'io: stops the team on entering rest');
    comes('io/state.state == "rest" and ganymede/state.state == "rest"');
    say('start', '--team');
    comes('io/breaks.stopped == true and ganymede/breaks.stopped == true');
    const told = newest('ganymede/breaks');
    assert.deepEqual([told.stopped_by, told.break_robot, told.author], [TEAM, 'io', 'anna']);
    assert.deepEqual(told.break_point, { from_state: '', to_state: 'rest', kind: STOP_TEAM });
    assert.equal(newest('ganymede/state').held, true);
    assert.equal(say('step', '--robot', 'ganymede'), 'ganymede: goes on until its next change of state');
    assert.equal(say('hold', '--robot', 'ganymede'), 'ganymede: stands still');
    assert.equal(say('resume', '--team'), 'ganymede: goes on\nio: goes on; it was stopped by break point on entering rest (anna)');
  });

  await t.test('what is wrong is said, and ends with 1', () => {
    assert.equal(say('break', '--clear', '--team'), 'ganymede: has no break points\nio: has no break points');
    assert.equal(say('break', 'rset', '--robot', 'io'), "io: stops on entering rset; its program has no state 'rset'");
    const full = run('break', ...Array.from({ length: 32 }, (_, i) => `state_${i}`), '--robot', 'io');
    assert.equal(full.status, 1);
    assert.equal(full.stdout, 'io: refused: it would have 33 break points, and 32 are the most: take some off first\n');
    const absent = run('break', 'go', '--remove', '--robot', 'io');
    assert.deepEqual([absent.status, absent.stdout], [1, 'io: refused: there is no break point on entering go\n']);
    assert.match(run('break', 'go', '--robot', 'europa').stderr, /^galilean break: europa sends no state; /);
  });
});
