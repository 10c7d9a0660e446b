// SPDX-License-Identifier: BSD-3-Clause
// One hand on the wheel, among programs: two operators over HTTP and by command.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { eventually, galilean, Running, startMonitor } from './tools.mjs';

const PROGRAM = 'states:\n  state:\n    name: "start"\n  end\nend\n';

/** Posts as an operator of that name, and returns the status and the answer. */
const asOperator = (url, token, name) => async (path, body) => {
  const headers = { authorization: `Bearer ${token('operator')}`, 'x-galilean-operator': encodeURIComponent(name), 'x-galilean-client': `${name}s tab` };
  const response = await fetch(url + path, body && { method: 'POST', headers, body: JSON.stringify(body) } || { headers });
  return { status: response.status, ...(await response.json()) };
};

test('two operators take turns at a robot, and everybody may stop it', { timeout: 120_000 }, async (t) => {
  const { monitor, domain, cwd, url, token } = await startMonitor(t);
  const ada = asOperator(url, token, 'Ada'), ben = asOperator(url, token, 'Ben');
  const leaseOf = async () => (await ada('/api/status')).robots[0].lease;
  const options = ['--monitor', url, '--token-file', join(cwd, 'operator.token')];
  const lease = (...words) => galilean(['lease', ...words, ...options], { domain, cwd });
  const file = join(cwd, 'mine.bhdl');
  writeFileSync(file, PROGRAM);

  await t.test('nobody holds it until somebody steers it, and the other is told who does', async () => {
    assert.equal(await leaseOf(), null);
    assert.match(lease('list').stdout, /^io +nobody$/m);
    assert.equal((await ada('/api/command', { kind: 'resume', targets: ['io'] })).status, 200);
    const refused = await ben('/api/command', { kind: 'resume', targets: ['io'] });
    assert.deepEqual([refused.status, refused.detail], [409, 'Nothing was done: Ada holds io. Ask for it, or take it over with a reason.']);
    assert.match(lease('list').stdout, /^io +Ada$/m);
  });

  await t.test('a push by command is refused, says who holds the robot, and what to do', () => {
    const { status, stderr } = galilean(['swap', file, '--robot', 'io', ...options], { domain, cwd });
    assert.equal(status, 1);
    assert.match(stderr, /Ada holds io/);
    assert.match(stderr, /galilean lease ask/);
  });

  await t.test('a stop never waits for a lease', async () => {
    for (const body of [{ kind: 'hold' }, { kind: 'hold', targets: ['io'] }, { kind: 'decommission', targets: ['io'] }])
      assert.equal((await ben('/api/command', body)).status, 200, JSON.stringify(body));
    assert.equal((await ada('/api/command', { kind: 'commission', targets: ['io'] })).status, 200);
  });

  await t.test('it is asked for and given', async () => {
    assert.equal((await ben('/api/lease', { do: 'ask', robots: ['io'] })).status, 200);
    assert.equal((await leaseOf()).asker.name, 'Ben');
    assert.equal((await ada('/api/lease', { do: 'give', robots: ['io'] })).status, 200);
    assert.equal((await leaseOf()).holder.name, 'Ben');
    await monitor.line(/lease of io: Ada gave it to Ben/);
  });

  await t.test('a command takes it over with a reason, holds it until Ctrl-C, and lets it go then', async () => {
    assert.notEqual(lease('take', '--robot', 'io').status, 0);
    const taking = new Running(t, ['lease', 'take', '--robot', 'io', '--reason', 'it stands in the door', ...options], { domain, cwd });
    await taking.line(/io is yours until Ctrl-C/);
    await monitor.line(/took it over from Ben: it stands in the door/);
    assert.equal((await ben('/api/command', { kind: 'resume', targets: ['io'] })).status, 409);
    assert.deepEqual(await taking.stop(), { code: 0, signal: null });
    assert.equal(await leaseOf(), null);
  });

  await t.test('a push by command takes it, and lets it go at its end', async () => {
    const { status, stderr } = galilean(['swap', file, '--robot', 'io', ...options], { domain, cwd });
    assert.equal(status, 0, stderr);
    assert.equal(await leaseOf(), null);
  });

  await t.test('whoever says nothing for ten seconds holds nothing any more', async () => {
    assert.equal((await ben('/api/command', { kind: 'resume', targets: ['io'] })).status, 200);
    await eventually(async () => (await leaseOf()) === null);
    await monitor.line(/lease of io: Ben says nothing any more; nobody holds it now/);
  });
});
