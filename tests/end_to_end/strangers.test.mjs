// SPDX-License-Identifier: BSD-3-Clause
// Whoever is in the DDS domain can write what he likes. The monitor goes on, says so, and ends when it is told to.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { within } from '../tools/patience.mjs';
import { eventually, galileanBinary, getJson, startMonitor } from './tools.mjs';

async function startStranger(t, domain) {
  const stranger = spawn(join(dirname(dirname(galileanBinary)), 'tests/wire_stranger'), [domain], { stdio: ['pipe', 'pipe', 'inherit'] });
  const ended = once(stranger, 'close');
  t.after(() => {
    stranger.stdin.end();
    return within(ended, () => 'the end of wire_stranger');
  });
  await within(once(stranger.stdout, 'data'), () => 'wire_stranger to begin');
}

test('a stranger who invents robots and numbers holds no monitor', { timeout: 180_000 }, async (t) => {
  const { monitor, domain, url, token } = await startMonitor(t);
  const headers = { authorization: `Bearer ${token('operator')}` };
  const status = () => getJson(`${url}/api/status`, { headers });
  await startStranger(t, domain);

  await eventually(async () => {
    const refused = (await status()).refused_messages;
    const names = (part) => refused.some(({ reason, messages }) => reason.includes(part) && messages > 0);
    return names('Sightings.view_angle_rad') && names('robots are not followed') && names('ObjectMap.robots');
  });
  const { robots, now_ns } = await status();
  assert.ok(robots.length <= 256, `${robots.length} robots`);
  await eventually(async () => {
    const told = await status();
    const [robot, channel] = [told.robots.find(({ name }) => name === 'io'), told.channels.find(({ topic }) => topic === 'rt/io/state')];
    return robot.age_s < 2 && channel.age_s < 2;
  });
  assert.ok(Math.abs(now_ns / 1e6 - Date.now()) < 10_000);
  await monitor.line(/a message on rt\/stranger\/sightings was ignored: Sightings\.view_angle_rad is not from 0 to 6\.3/);
  assert.equal(monitor.output.match(/Sightings\.view_angle_rad/g).length, 1, 'each reason is told once');
  const metrics = await (await fetch(`${url}/metrics`, { headers })).text();
  assert.match(metrics, /^galilean_refused_messages_total\{topic="rt\/stranger\/sightings",reason="[^"]+"\} \d+$/m);

  const asked_ms = Date.now();
  const { code } = await monitor.stop('SIGTERM');
  assert.equal(code, 0);
  // Alone on its machine it takes a second at most: its writers wait so long for those who read.
  assert.ok(Date.now() - asked_ms < 5000, `it took ${Date.now() - asked_ms} ms`);
});
