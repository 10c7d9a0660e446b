// SPDX-License-Identifier: BSD-3-Clause
// People's own tokens: what they open, how they end, and what happens to who tries others.
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { once } from 'node:events';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { within } from '../tools/patience.mjs';
import { eventually, galilean, root, scratchFolder, startMonitor } from './tools.mjs';

const { WebSocket } = createRequire(`${root}tests/node/`)('ws');
const FOXGLOVE = ['foxglove.websocket.v1'];

const tokens = (cwd, ...words) => galilean(['tokens', ...words, '--data', cwd]);

/** The token that somebody is given. */
function give(cwd, name, ...options) {
  const { status, stdout, stderr } = tokens(cwd, 'add', name, ...options);
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^[0-9a-f]{64}\n$/);
  return stdout.trim();
}

/** The answer to one request on a connection of its own, without its body. */
const ask = (url, bearer, { path = '/api/status', method = 'GET', body, localAddress } = {}) =>
  within(new Promise((resolve, reject) => {
    const headers = { authorization: `Bearer ${bearer}` };
    request(url + path, { method, headers, localAddress, agent: false }, (response) => {
      response.resume().on('end', () => resolve(response));
    }).on('error', reject).end(body);
  }), () => `an answer from ${url}${path}`);

/** Asks now and then: a token that the monitor does not know yet is a wrong one, and too many of these get 429. */
const patiently = (question) => eventually(async () => (await question()) || delay(50));
const known = (url, bearer) => patiently(async () => (await ask(url, bearer)).statusCode === 200);

async function opened(t, url, path, bearer, protocols = FOXGLOVE) {
  const socket = new WebSocket(`${url.replace('http', 'ws')}${path}`, protocols, { headers: { authorization: `Bearer ${bearer}` } });
  t.after(() => socket.terminate());
  await within(once(socket, 'open'), () => `${path} to open`);
  return socket;
}

/** A WebSocket whose client hears everything and never answers, also no close frame. */
async function deaf(t, url, bearer) {
  const asked = request(`${url}/ws`, {
    agent: false,
    headers: {
      connection: 'Upgrade', upgrade: 'websocket', 'sec-websocket-version': '13',
      'sec-websocket-key': randomBytes(16).toString('base64'), 'sec-websocket-protocol': FOXGLOVE[0],
      authorization: `Bearer ${bearer}`,
    },
  }).end();
  const [, socket] = await within(once(asked, 'upgrade'), () => 'an upgrade');
  t.after(() => socket.destroy());
  return socket.on('error', () => {}).resume();
}

test('a named token opens what its role may, and what is open closes when it is revoked', async (t) => {
  const { url, cwd } = await startMonitor(t, ['--plain'], '0.0.0.0:0');
  const [anna, bert] = [give(cwd, 'anna'), give(cwd, 'bert', '--role', 'operator')];
  await known(url, anna);
  await known(url, bert);
  const hold = { path: '/api/command', method: 'POST', body: '{"kind": "hold"}' };
  assert.equal((await ask(url, anna, hold)).statusCode, 403);
  assert.equal((await ask(url, bert, hold)).statusCode, 200);

  const annas = [await opened(t, url, '/ws', anna), await opened(t, url, '/lsp', anna, [])];
  const mute = await deaf(t, url, anna);
  const berts = await opened(t, url, '/ws', bert);
  const closed = annas.map((socket) => once(socket, 'close'));
  const cut = once(mute, 'close');
  assert.equal(tokens(cwd, 'revoke', 'anna').status, 0);
  const revoked_ms = performance.now();
  for (const each of closed) {
    const [code, reason] = await within(each, () => 'a revoked socket to close');
    assert.equal(code, 1008);
    assert.match(String(reason), /revoked/);
  }
  await within(cut, () => 'a revoked socket to be cut');
  const took_ms = performance.now() - revoked_ms;
  assert.ok(took_ms < 1000, `it took ${took_ms} ms`);
  assert.equal((await ask(url, anna)).statusCode, 401);
  assert.equal((await ask(url, bert)).statusCode, 200);
  assert.equal(berts.readyState, WebSocket.OPEN);
  const metrics = await (await fetch(`${url}/metrics`, { headers: { authorization: `Bearer ${bert}` } })).text();
  assert.match(metrics, /^galilean_websocket_revoked_total 3$/m);
});

test('a token that expires ends what it has opened, also where reading is free', async (t) => {
  const { url, cwd } = await startMonitor(t);
  const clara = give(cwd, 'clara', '--role', 'operator', '--expires', '8s');
  const maySteer = async () => (await (await fetch(`${url}/api/status`, { headers: { authorization: `Bearer ${clara}` } })).json()).may_steer;
  await patiently(maySteer);
  const socket = await opened(t, url, '/ws', clara);
  const [code] = await within(once(socket, 'close'), () => 'an expired socket to close');
  assert.equal(code, 1008);
  assert.equal(await maySteer(), false);
});

test('a token is shown once, and neither listed nor kept', (t) => {
  const cwd = scratchFolder(t);
  const anna = give(cwd, 'anna', '--expires', '8h');
  const listed = tokens(cwd, 'list').stdout;
  assert.match(listed, /^anna {2}viewer {2}made \S+Z {2}expires \S+Z\n$/);
  const [entry] = JSON.parse(tokens(cwd, 'list', '--json').stdout).tokens;
  assert.deepEqual([entry.name, entry.role, entry.expired], ['anna', 'viewer', false]);
  const file = join(cwd, 'tokens.json');
  for (const text of [listed, readFileSync(file, 'utf8')]) assert.ok(!text.includes(anna));
  assert.equal(statSync(file).mode & 0o777, 0o600);
  const again = tokens(cwd, 'add', 'anna');
  assert.deepEqual([again.status, again.stdout], [1, '']);
  assert.match(again.stderr, /revoke it first/);
  assert.match(tokens(cwd, 'revoke', 'anan').stderr, /did you mean 'anna'\?/);
});

test('who tries tokens is told to wait, and a right one passes from there and from elsewhere', async (t) => {
  const { url, token, monitor } = await startMonitor(t, ['--plain'], '0.0.0.0:0');
  const statuses = [];
  for (let i = 0; i < 40; ++i) statuses.push((await ask(url, `guess-${i}`)).statusCode);
  assert.deepEqual(statuses, [...Array(10).fill(401), ...Array(30).fill(429)]);
  const refused = await ask(url, 'guess-40');
  const wait_s = Number(refused.headers['retry-after']);
  assert.ok(wait_s >= 1 && wait_s <= 60, `${wait_s} s`);
  const socket = new WebSocket(`${url.replace('http', 'ws')}/ws?token=guess-41`, FOXGLOVE);
  socket.on('error', () => {});
  const [, answer] = await within(once(socket, 'unexpected-response'), () => 'an answer to an upgrade');
  assert.equal(answer.statusCode, 429);
  socket.terminate();

  assert.equal((await ask(url, token('operator'))).statusCode, 200);
  assert.equal((await ask(url, 'guess-42', { localAddress: '127.0.0.2' })).statusCode, 401);
  const metrics = await (await fetch(`${url}/metrics`, { headers: { authorization: `Bearer ${token('viewer')}` } })).text();
  assert.match(metrics, /^galilean_http_wrong_tokens_total 43$/m);
  assert.match(metrics, /^galilean_http_held_off_total 32$/m);
  await monitor.line(/127\.0\.0\.1 sends too many wrong tokens/);
});

test('a page that was left open with an old token reads on where reading is free', async (t) => {
  const { url } = await startMonitor(t);
  for (let i = 0; i < 50; ++i) assert.equal((await ask(url, 'old')).statusCode, 200);
});

test('tokens that were damaged give no right, and the log says so', async (t) => {
  const { url, cwd, token, monitor } = await startMonitor(t);
  writeFileSync(join(cwd, 'tokens.json'), '{"tokens": [', { mode: 0o600 });
  await monitor.line(/tokens\.json is damaged: .*; until then no named token gives a right/);
  assert.equal(tokens(cwd, 'add', 'anna').status, 1);
  assert.equal((await ask(url, token('operator'), { path: '/api/command', method: 'POST', body: '{"kind": "hold"}' })).statusCode, 200);
});

test("the monitor's output, which a service keeps, holds no token", async (t) => {
  const { monitor, token } = await startMonitor(t);
  await monitor.line(/To steer the team, open http:\/\/\S+\/#token=TOKEN with the token in \S+operator\.token\n/);
  for (const name of ['operator', 'viewer']) assert.ok(!monitor.output.includes(token(name)), name);
});
