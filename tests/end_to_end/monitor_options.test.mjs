// SPDX-License-Identifier: BSD-3-Clause
// What a monitor's options change: who may read, who is silent, and where the map says that robots started.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { within } from '../tools/patience.mjs';
import { connect, readerOf } from './foxglove_client.mjs';
import { eventually, getJson, root, startMonitor } from './tools.mjs';

const { WebSocket } = createRequire(`${root}tests/node/`)('ws');

/** How the monitor answers who would open a WebSocket there: 101 if it does. */
async function upgraded(url, headers = {}, path = '/ws') {
  const socket = new WebSocket(`${url.replace('http', 'ws')}${path}`, ['foxglove.websocket.v1'], { headers });
  socket.on('error', () => {});
  const refused = once(socket, 'unexpected-response').then(([, { statusCode }]) => statusCode);
  const status = await within(Promise.race([once(socket, 'open').then(() => 101), refused]), () => 'an answer to an upgrade');
  socket.terminate();
  return status;
}

test('options of the map, of silence and of other pages', async (t) => {
  const studio = 'https://studio.example';
  const { robot, url } = await startMonitor(t, ['--start', 'io:1,2,90', '--silent-after', '3', '--allow-origin', studio]);

  await t.test('--allow-origin lets that page in, and no other', async () => {
    const asked = await fetch(`${url}/api/status`, { headers: { origin: studio } });
    assert.deepEqual([asked.status, asked.headers.get('access-control-allow-origin')], [200, studio]);
    assert.equal(await upgraded(url, { origin: studio }), 101);
    for (const other of [url.replace('http:', 'https:'), 'https://evil.example', `${studio}.evil`, 'http://studio.example']) {
      assert.equal((await fetch(`${url}/api/status`, { headers: { origin: other } })).status, 403, other);
      assert.equal(await upgraded(url, { origin: other }), 403, other);
    }
  });

  await t.test('--start says where a robot began in the map', async (inner) => {
    const { client, next, channel } = connect(inner, url);
    const tf = await channel('/tf');
    client.subscribe(tf.id);
    const begins = ({ data }) => readerOf(tf).readMessage(data).transforms
      .find(({ header, child_frame_id: child }) => header.frame_id === 'map' && child === 'io/odom');
    const { transform: { translation, rotation } } = begins(await next('message', begins));
    const near = (value, wanted) => assert.ok(Math.abs(value - wanted) < 0.01, `${value} is not ${wanted}`);
    near(translation.x, 1);
    near(translation.y, 2);
    near(2 * Math.atan2(rotation.z, rotation.w), Math.PI / 2);
  });

  await t.test('--silent-after says when a robot is silent', async () => {
    robot.process.kill('SIGKILL');
    const io = async () => (await getJson(`${url}/api/status`)).robots[0];
    const silent = await eventually(async () => {
      const now = await io();
      return now.silent && now;
    });
    assert.ok(silent.age_s >= 3, `silent after ${silent.age_s} s`);
  });
});

test('on another address than loopback nobody reads without a token', async (t) => {
  const { monitor, url, token } = await startMonitor(t, ['--plain'], '0.0.0.0:0');
  const ask = (path, bearer) => fetch(url + path, { headers: bearer ? { authorization: `Bearer ${bearer}` } : {} });
  for (const path of ['/api/status', '/api/programs', '/metrics', '/api/recordings']) {
    const refused = await ask(path);
    assert.equal(refused.status, 401, path);
    assert.equal(refused.headers.get('www-authenticate'), 'Bearer');
    assert.equal((await ask(path, 'wrong')).status, 401, path);
    for (const name of ['viewer', 'operator']) assert.equal((await ask(path, token(name))).status, 200, `${path} as ${name}`);
  }
  for (const path of ['/healthz', '/']) assert.equal((await ask(path)).status, 200, path);
  assert.equal(await upgraded(url), 401);
  assert.equal(await upgraded(url, {}, '/replay?recording=run.mcap'), 401);
  assert.equal(await upgraded(url, { authorization: `Bearer ${token('viewer')}` }), 101);
  const command = (bearer) => fetch(`${url}/api/command`, { method: 'POST', headers: { authorization: `Bearer ${bearer}` }, body: '{"kind": "hold"}' });
  assert.equal((await command(token('viewer'))).status, 403);
  assert.equal((await command(token('operator'))).status, 200);
  assert.deepEqual(await monitor.stop(), { code: 0, signal: null });
});
