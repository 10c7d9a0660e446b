// SPDX-License-Identifier: BSD-3-Clause
// Who may move a robot that trusts keys, and who may stop it: an operator, and a stranger in the same DDS domain.
import assert from 'node:assert/strict';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { eventually, freshDomain, galilean, getJson, programs, Running, scratchFolder, startTeam } from './tools.mjs';

const limit = { timeout: 120_000 };
const NOT_TRUSTED = 'it is not signed by a key that this robot trusts';

/** A person at a computer: `run` gives commands, and what belongs to the person is in `state`. */
function person(t, domain) {
  const env = { XDG_STATE_HOME: scratchFolder(t) };
  return { env, state: join(env.XDG_STATE_HOME, 'galilean'), run: (...args) => galilean(args, { domain, env }) };
}

/** A robot without a board and a camera that trusts one person, who is the operator; and a stranger. */
async function startTrustingRobot(t) {
  const domain = freshDomain();
  const [operator, stranger] = [person(t, domain), person(t, domain)];
  const trust = join(scratchFolder(t), 'team.keys');
  writeFileSync(trust, `# the lab\n${operator.run('keys').stdout}`);
  const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none',
    '--camera', 'shm:none', '--trust', trust], { domain });
  await robot.line(/comm_port/);
  return { robot, domain, operator, stranger };
}

test('the key is made once, is its owner\'s alone, and its line can be copied', limit, (t) => {
  const { run, state } = person(t, freshDomain());
  const first = run('keys');
  assert.equal(first.status, 0, first.stderr);
  assert.match(first.stdout, /^ed25519 [A-Za-z0-9+/]{43}= \S+@\S+\n$/);
  assert.match(first.stderr, /made a new key, which is kept in .*operator\.key\n$/);
  assert.equal(statSync(join(state, 'operator.key')).mode & 0o777, 0o600);
  assert.equal(readFileSync(join(state, 'operator.key.pub'), 'utf8'), first.stdout);
  assert.deepEqual(run('keys'), { ...first, stderr: '' });
});

test('anybody holds a robot, and only whom it trusts lets it go on', limit, async (t) => {
  const { robot, operator, stranger } = await startTrustingRobot(t);
  const held = stranger.run('hold', '--robot', 'io');
  assert.deepEqual([held.status, held.stdout], [0, 'io: stands still\n'], held.stderr);
  for (const order of ['resume', 'commission']) {
    if (order === 'commission') assert.equal(stranger.run('decommission', '--robot', 'io').status, 0);
    const refused = stranger.run(order, '--robot', 'io');
    assert.equal(refused.status, 1, refused.stdout);
    assert.match(refused.stdout, new RegExp(`^io: refused: ${NOT_TRUSTED}; .*--key FILE`));
  }
  await robot.line(new RegExp(`A resume by 'command'( \\([^)]+\\))? was refused: ${NOT_TRUSTED}\\.`));
  assert.equal(operator.run('commission', '--robot', 'io').status, 0);
  const resumed = operator.run('resume', '--robot', 'io');
  assert.deepEqual([resumed.status, resumed.stdout], [0, 'io: goes on\n'], resumed.stderr);
});

test('a key that is brought along does, too, and a step and break points are refused to others', limit, async (t) => {
  const { operator, stranger } = await startTrustingRobot(t);
  const key = join(operator.state, 'operator.key');
  const set = stranger.run('break', 'grab_trash', '--robot', 'io');
  assert.equal(set.status, 0, set.stdout + set.stderr);
  for (const order of [['break', 'wander_for_trash', '--lock'], ['break', '--clear'], ['step']]) {
    const refused = stranger.run(...order, '--robot', 'io');
    assert.equal(refused.status, 1, refused.stdout);
    assert.match(refused.stdout, new RegExp(`^io: refused: ${NOT_TRUSTED}`));
    const taken = stranger.run(...order, '--robot', 'io', '--key', key);
    assert.equal(taken.status, 0, taken.stdout + taken.stderr);
  }
  const missing = stranger.run('step', '--robot', 'io', '--key', `${key}.none`);
  assert.equal(missing.status, 1);
  assert.match(missing.stderr, /operator\.key\.none cannot be read: /);
});

test('a robot runs the programs of whom it trusts, whatever others call themselves', limit, async (t) => {
  const { robot, domain, operator, stranger } = await startTrustingRobot(t);
  const swap = ({ run }) => run('swap', `${programs}/sit_and_spin.bhdl`, '--robot', 'io', '--direct');
  const refused = swap(stranger);
  assert.equal(refused.status, 1, refused.stdout);
  assert.match(refused.stdout, new RegExp(`rejected.*${NOT_TRUSTED}`));
  // A stranger's monitor joins DDS as `monitor`, which robots without keys obey.
  const monitor = new Running(t, ['monitor', '--listen', '127.0.0.1:0'], { domain, env: stranger.env });
  const [url] = await monitor.line(/http:\/\/[0-9.]+:\d+/);
  await eventually(async () => (await getJson(`${url}/api/status`)).robots.some((each) => each.program_hash));
  const token = join(stranger.state, 'operator.token');
  const through = stranger.run('swap', `${programs}/sit_and_spin.bhdl`, '--robot', 'io', '--monitor', url, '--token-file', token);
  assert.equal(through.status, 1, through.stdout);
  assert.match(through.stdout + through.stderr, new RegExp(NOT_TRUSTED));
  await robot.line(new RegExp(`A push of program \\w+ by 'monitor'( \\([^)]+\\))? was refused: ${NOT_TRUSTED}\\.`));
  const taken = swap(operator);
  assert.equal(taken.status, 0, taken.stdout + taken.stderr);
  await robot.line(/\(program swapped\)/);
});

test('beside the demo its user\'s commands work without a word, and a stranger\'s do not', limit, async (t) => {
  const { domain } = await startTeam(t, ['--robots', '1']);
  const stranger = person(t, domain);
  assert.equal(stranger.run('hold', '--robot', 'io').status, 0);
  const refused = stranger.run('resume', '--robot', 'io');
  assert.equal(refused.status, 1, refused.stdout);
  assert.match(refused.stdout, new RegExp(NOT_TRUSTED));
  const resumed = galilean(['resume', '--robot', 'io'], { domain });
  assert.equal(resumed.status, 0, resumed.stdout + resumed.stderr);
});

test('a robot does not start with keys that it cannot read', limit, (t) => {
  const trust = join(scratchFolder(t), 'team.keys');
  writeFileSync(trust, '# nobody\nssh-ed25519 AAAA anna\n');
  const refused = galilean(['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none',
    '--camera', 'shm:none', '--trust', trust], { domain: freshDomain() });
  assert.equal(refused.status, 1, refused.stdout);
  assert.match(refused.stderr, /galilean-robot: .*team\.keys:2: a line begins with 'ed25519'/);
});

test('the keys of the machine count where none are named, and a robot without keys says what that means', limit, async (t) => {
  const domain = freshDomain();
  const [operator, stranger] = [person(t, domain), person(t, domain)];
  const trust = join(scratchFolder(t), 'team.keys');
  writeFileSync(trust, operator.run('keys').stdout);
  const start = (name, env) => new Running(t, ['robot', '--name', name, '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none',
    '--camera', 'shm:none'], { domain, env });
  const trusting = start('io', { GALILEAN_TRUST: trust });
  await trusting.line(/comm_port/);
  const refused = stranger.run('resume', '--robot', 'io');
  assert.equal(refused.status, 1, refused.stdout);
  assert.match(refused.stdout, new RegExp(NOT_TRUSTED));
  assert.doesNotMatch(trusting.output, /can move this robot/);
  await start('ganymede', { GALILEAN_TRUST: '' }).line(/whoever is in this DDS domain can move this robot: name those who may with --trust FILE/);
});

test('a robot trusts several keys, until a line is deleted and it is started again, and remembers how far their orders came', limit, async (t) => {
  const domain = freshDomain();
  const [anna, ben] = [person(t, domain), person(t, domain)];
  const trust = join(scratchFolder(t), 'team.keys'), state = scratchFolder(t);
  const lines = [anna, ben].map(({ run }) => run('keys').stdout);
  writeFileSync(trust, lines.join(''));
  const start = async () => {
    const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none',
      '--camera', 'shm:none', '--trust', trust], { domain, env: { XDG_STATE_HOME: state } });
    await robot.line(/comm_port/);
    return robot;
  };
  const robot = await start();
  for (const { run } of [anna, ben]) {
    assert.equal(run('hold', '--robot', 'io').status, 0);
    const resumed = run('resume', '--robot', 'io');
    assert.equal(resumed.status, 0, resumed.stdout + resumed.stderr);
  }
  await robot.stop();
  const kept = join(state, `galilean/robots/domain_${domain}/io.orders`);
  assert.match(readFileSync(kept, 'utf8'), /^galilean orders, version 1\n([0-9a-f]{16} \d+\n){2}end\n$/);
  assert.equal(statSync(kept).mode & 0o777, 0o600);

  writeFileSync(trust, lines[0]);
  await start();
  assert.equal(ben.run('hold', '--robot', 'io').status, 0);
  const refused = ben.run('resume', '--robot', 'io');
  assert.equal(refused.status, 1, refused.stdout);
  assert.match(refused.stdout, new RegExp(`^io: refused: ${NOT_TRUSTED}`));
  const resumed = anna.run('resume', '--robot', 'io');
  assert.equal(resumed.status, 0, resumed.stdout + resumed.stderr);
});
