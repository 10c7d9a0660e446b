// SPDX-License-Identifier: BSD-3-Clause
// Types that Galilean was not built with, written by a program of somebody else.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { within } from '../tools/patience.mjs';
import { freshDomain, galilean, galileanBinary } from './tools.mjs';

async function startTalker(t) {
  const domain = freshDomain();
  const talker = spawn(join(dirname(dirname(galileanBinary)), 'tests/foreign_talker'), [domain], { stdio: ['pipe', 'pipe', 'inherit'] });
  const ended = once(talker, 'close');
  t.after(() => {
    talker.stdin.end();
    return within(ended, () => 'the end of foreign_talker');
  });
  await within(once(talker.stdout, 'data'), () => 'foreign_talker to talk');
  return domain;
}

test('messages of any type are read, measured and awaited', { timeout: 120_000 }, async (t) => {
  const domain = await startTalker(t);
  const said = (...args) => galilean(args, { domain });
  const json = (...args) => {
    const { status, stdout, stderr } = said(...args, '--json');
    assert.equal(status, 0, stderr);
    assert.equal(stderr, '');
    return stdout.trim().split('\n').map((line) => JSON.parse(line));
  };

  assert.deepEqual(json('echo', 'foreign/report', '--count', '2')[1], {
    best: { words: 'best', weight: 12 }, worst: { words: 'worst', weight: null },
    others: [{ words: 'dull', weight: null }, { words: 'bright', weight: 12 }],
    first: { discriminator: 2, words: 'warm' },
    more: [{ discriminator: 7, found: ['MOTOR'] }, { discriminator: -1, code: 9 }],
    spot: { x_m: 3, y_m: 0.5 }, lost: null, last: 77,
  });
  const [plain] = json('echo', 'foreign/plain', '--count', '1');
  assert.deepEqual([plain.letter, plain.whole, plain.present_gear, plain.grid], ['q', -70000, 'DRIVE', [[1, 2, 3], [4, 5, 6]]]);
  assert.deepEqual(json('echo', 'foreign/settings', '--count', '1', '--field', 'owner.words'), ['io']);
  const text = said('echo', 'foreign/keyed', '--count', '1').stdout;
  assert.equal(text, 'id: 42\npart: "wheel"\nwords: "turns"\n---\n');

  const expression = 'foreign/plain.present_gear == "DRIVE" and foreign/settings.rest.x_m < -3 and foreign/report.last == 77';
  assert.equal(json('wait', expression, '--timeout', '20')[0].holds, true);
  const [rate] = json('rate', 'foreign/keyed', '--count', '5');
  assert.ok(rate.rate_hz > 1 && rate.rate_hz < 10, JSON.stringify(rate));

  const [[info]] = json('info', 'foreign/report', '--definition');
  assert.deepEqual(info.writers.map(({ participant, type, definition }) => [participant, type, definition]), [['talker', 'foreign::Report', 'its own']]);
  assert.match(info.definitions[0].idl, /@appendable struct Report \{\n {2}foreign::Tag best;\n/);
});

test('a type of a known name that is defined otherwise is decoded by its own definition', { timeout: 60_000 }, async (t) => {
  const domain = await startTalker(t);
  const { status, stdout, stderr } = galilean(['echo', 'io/state', '--count', '1', '--json'], { domain });
  assert.equal(status, 0);
  assert.deepEqual(JSON.parse(stdout), { robot: 'io', charge: 0.75 });
  assert.equal(stderr, "galilean echo: talker's definition of galilean_msgs/msg/RobotState differs from ours: its messages are decoded by its own\n");
  assert.match(galilean(['info', 'io/state'], { domain }).stdout, /written by talker .*; its definition differs from ours\n/);
});

test('of a writer without type information everything but the messages is shown', { timeout: 60_000 }, async (t) => {
  const domain = await startTalker(t);
  const echo = galilean(['echo', 'foreign/bare', '--count', '1'], { domain });
  assert.equal(echo.status, 1);
  assert.match(echo.stderr, /^galilean echo: messages of talker on '\/foreign\/bare' cannot be decoded: talker publishes no type information, .*; use 'ros2 topic echo'.*\n$/);
  const rate = galilean(['rate', 'foreign/bare', '--count', '3', '--json'], { domain });
  assert.equal(JSON.parse(rate.stdout).messages, 3);
  assert.match(galilean(['info', 'foreign/bare'], { domain }).stdout, /; it publishes no definition\n/);
  const wait = galilean(['wait', 'foreign/bare.number == 11', '--timeout', '5'], { domain });
  assert.equal(wait.status, 1);
  assert.match(wait.stderr, /message(s of 'foreign\/bare' were| of 'foreign\/bare' was) left out: .* publishes no type information/);
});
