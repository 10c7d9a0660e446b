// SPDX-License-Identifier: BSD-3-Clause
// The HTTP interface, held against its description and against readers that others wrote.
import assert from 'node:assert/strict';
import { request } from 'node:http';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { gunzipSync } from 'node:zlib';
import { description, lint, objections } from './openapi.mjs';
import { within } from '../tools/patience.mjs';
import { makeRecording } from './small_recording.mjs';
import { eventually, getJson, root, startMonitor } from './tools.mjs';

const require = createRequire(`${root}tests/node/`);
const parsePrometheus = require('parse-prometheus-text-format');

test('the description is one, and a linter has nothing to say against it', async () => {
  assert.match(description.openapi, /^3\.1/);
  assert.deepEqual(await lint(), []);
});

test('the server answers as it is described', async (t) => {
  const { url, token } = await startMonitor(t);
  await eventually(async () => (await fetch(`${url}/api/map.png`)).status === 200);
  const program = { files: [{ path: 'a.bhdl', text: 'states:\n  state:\n    name: "start"\n  end\nend\n' }] };
  const broken = { files: [{ path: 'a.bhdl', text: 'states:\n  nonsense\n' }] };
  const asked = new Set();

  const ask = async (method, path, { status, body, bearer = token('operator'), headers = {}, ...values }) => {
    const target = path.replace(/\{(\w+)\}/, (_, name) => encodeURIComponent(values[name]));
    const response = await fetch(url + target, {
      method, body: body === undefined || body instanceof Uint8Array ? body : JSON.stringify(body),
      headers: { ...(bearer ? { authorization: `Bearer ${bearer}` } : {}), ...headers },
    });
    asked.add(`${method} ${path}`);
    const copy = response.clone();
    assert.equal(response.status, status, `${method} ${path}: ${await copy.text()}`);
    assert.deepEqual(await objections(method, path, response.clone()), []);
    return /json/.test(response.headers.get('content-type')) ? response.json() : response.text();
  };

  await t.test('what can be read', async () => {
    for (const path of ['/healthz', '/metrics', '/api/status', '/api/team', '/api/programs', '/api/pushes', '/api/orders', '/api/strategies', '/api/map.png', '/api/map.yaml', '/api/map.3Dscene'])
      await ask('GET', path, { status: 200 });
    await ask('GET', '/api/programs/{name}', { status: 200, name: 'office_cleanup.bhdl' });
    await ask('GET', '/api/programs/{name}', { status: 404, name: 'nothing.bhdl' });
    await ask('GET', '/api/pushes/{id}', { status: 404, id: 'nothing' });
    await ask('GET', '/api/pushed/{hash}', { status: 404, hash: '0123' });
    await ask('GET', '/recordings/{name}', { status: 404, name: 'nothing.mcap' });
  });

  await t.test('recordings', async () => {
    const [path, body, name] = ['/api/recordings/{name}', await makeRecording(), 'run.mcap'];
    await ask('PUT', path, { status: 403, name, body, bearer: token('viewer') });
    await ask('PUT', path, { status: 400, name: 'run.txt', body });
    await ask('PUT', path, { status: 422, name, body: Buffer.from('no recording') });
    await ask('PUT', path, { status: 201, name, body });
    await ask('PUT', path, { status: 409, name, body });
    assert.equal((await ask('GET', '/api/recordings', { status: 200 })).recordings.length, 1);
    for (const method of ['GET', 'HEAD']) await ask(method, '/recordings/{name}', { status: 200, name });
    const { programs, uncounted } = await ask('GET', '/api/recordings/{name}/coverage', { status: 200, name });
    assert.deepEqual([programs, uncounted.length], [[], 2], 'its types are of another release');
    await ask('GET', '/api/recordings/{name}/coverage', { status: 404, name: 'nothing.mcap' });
    await ask('GET', '/recordings/{name}', { status: 206, name, headers: { range: 'bytes=0-7' } });
    await ask('GET', '/recordings/{name}', { status: 416, name, headers: { range: 'bytes=99999999-' } });
  });

  await t.test('what can be ordered, and what is refused', async () => {
    assert.equal((await ask('POST', '/api/check', { status: 200, body: program })).ok, true);
    assert.equal((await ask('POST', '/api/check', { status: 200, body: broken })).ok, false);
    await ask('POST', '/api/check', { status: 200, body: { ...program, against: program.files } });
    await ask('POST', '/api/check', { status: 400, body: {} });
    await ask('POST', '/api/push', { status: 403, body: program, bearer: token('viewer') });
    await ask('POST', '/api/push', { status: 422, body: broken });
    await ask('POST', '/api/push', { status: 404, body: { ...program, targets: ['europa'] } });
    await ask('POST', '/api/push', { status: 409, body: { ...program, replaces: 'ffff' } });
    const pushed = await ask('POST', '/api/push', { status: 200, body: program });
    await ask('GET', '/api/pushes/{id}', { status: 200, id: pushed.id });
    await eventually(async () => (await getJson(`${url}/api/pushes`)).pushes.length === 1);
    await ask('GET', '/api/pushes', { status: 200 });
    await ask('GET', '/api/strategies', { status: 200 });
    await ask('GET', '/api/pushed/{hash}', { status: 200, hash: pushed.hash.slice(0, 10) });
    await ask('POST', '/api/pushes/{id}/cancel', { status: 409, id: pushed.id, body: {} });
    await ask('POST', '/api/command', { status: 200, body: { kind: 'hold', targets: ['io'] } });
    for (const kind of ['decommission', 'commission', 'step', 'resume']) await ask('POST', '/api/command', { status: 200, body: { kind, targets: ['io'] } });
    await ask('POST', '/api/command', { status: 400, body: { kind: 'dance' } });
    await ask('POST', '/api/command', { status: 404, body: { kind: 'hold', targets: ['europa'] } });
    await ask('POST', '/api/breaks', { status: 200, body: { order: 'set', targets: ['io'], points: [{ from: 'start', to: 'wander_for_trash', kind: 'lock' }] } });
    await eventually(async () => (await getJson(`${url}/api/team`)).robots[0].breaks?.points.length === 1);
    await ask('GET', '/api/team', { status: 200 });
    await ask('POST', '/api/breaks', { status: 400, body: { order: 'set' } });
    await ask('POST', '/api/breaks', { status: 403, body: { order: 'clear' }, bearer: token('viewer') });
    await ask('POST', '/api/breaks', { status: 404, body: { order: 'clear', targets: ['europa'] } });
    const ben = { 'x-galilean-operator': 'Ben', 'x-galilean-client': 'a tab' };
    await ask('POST', '/api/lease', { status: 200, body: { do: 'ask', robots: ['io'] } });
    await ask('POST', '/api/lease', { status: 200, body: { do: 'ask', robots: ['io'] }, headers: ben });
    assert.equal((await ask('GET', '/api/status', { status: 200 })).robots[0].lease.asker.name, 'Ben');
    await ask('POST', '/api/lease', { status: 409, body: { do: 'give', robots: ['io'] }, headers: ben });
    await ask('POST', '/api/lease', { status: 400, body: { do: 'steal', robots: ['io'] } });
    await ask('POST', '/api/lease', { status: 403, body: { do: 'ask', robots: ['io'] }, bearer: token('viewer') });
    await ask('POST', '/api/lease', { status: 404, body: { do: 'ask', robots: ['europa'] } });
    await ask('POST', '/api/command', { status: 409, body: { kind: 'resume' }, headers: ben });
    await ask('POST', '/api/breaks', { status: 409, body: { order: 'clear' }, headers: ben });
    await ask('POST', '/api/push', { status: 409, body: program, headers: ben });
    await ask('POST', '/api/lease', { status: 200, body: { do: 'release' } });
    await ask('POST', '/api/simulation/orders', { status: 400, body: {} });
    await ask('POST', '/api/simulation/orders', { status: 403, body: { order: 'pause' }, bearer: token('viewer') });
    await ask('POST', '/api/simulation/orders', { status: 404, body: { order: 'pause' } });
    await ask('GET', '/api/status', { status: 403, headers: { origin: 'https://evil.example' } });
  });

  assert.deepEqual(Object.entries(description.paths)
    .flatMap(([path, item]) => Object.keys(item).map((method) => `${method.toUpperCase()} ${path}`))
    .filter((operation) => !asked.has(operation)), [], 'all that is described was asked');

  await t.test('errors are problems, and say what would be allowed', async () => {
    const wrong = await fetch(`${url}/api/push`);
    assert.equal(wrong.status, 405);
    assert.equal(wrong.headers.get('allow'), 'POST');
    assert.equal(wrong.headers.get('content-type'), 'application/problem+json');
    assert.equal((await wrong.json()).title, 'Method Not Allowed');
  });

  await t.test('what a client has is not sent again, and what is large goes as gzip', async () => {
    for (const path of ['/', '/api/programs', '/api/map.yaml', '/api/map.png']) {
      const first = await fetch(url + path);
      const again = await fetch(url + path, { headers: { 'if-none-match': first.headers.get('etag') } });
      assert.equal(again.status, 304, path);
      assert.equal((await fetch(url + path, { headers: { 'if-none-match': '"other"' } })).status, 200, path);
    }
    const large = await raw(`${url}/api/programs/office_cleanup.bhdl`, { 'accept-encoding': 'gzip' });
    assert.equal(large.headers['content-encoding'], 'gzip');
    assert.equal(large.headers.vary, 'Accept-Encoding');
    const text = gunzipSync(large.body);
    assert.ok(text.length > 2 * large.body.length);
    const plain = await raw(`${url}/api/programs/office_cleanup.bhdl`);
    assert.equal(plain.headers['content-encoding'], undefined);
    assert.deepEqual(plain.body, text);
  });

  await t.test('a file with a hash in its name may be kept for ever, the page that names it is asked for again', async () => {
    const page = await fetch(url);
    assert.equal(page.headers.get('cache-control'), 'no-cache');
    const host = new URL(url).host;
    const policy = page.headers.get('content-security-policy').split('; ');
    assert.ok(policy.includes(`connect-src 'self' ws://${host} wss://${host}`), policy);
    for (const forbidden of ['base-uri', 'form-action', 'frame-ancestors', 'object-src']) assert.ok(policy.includes(`${forbidden} 'none'`), forbidden);
    const [asset] = (await page.text()).match(/assets\/index-[\w-]{8}\.js/);
    const script = await fetch(`${url}/${asset}`);
    assert.equal(script.headers.get('cache-control'), 'public, max-age=31536000, immutable');
    assert.equal(script.headers.get('content-encoding'), 'gzip');
  });

  await t.test("Prometheus' format is read by another's parser", async () => {
    const families = parsePrometheus(await (await fetch(`${url}/metrics`)).text());
    const value = (name) => families.find((family) => family.name === name)?.metrics[0];
    assert.equal(value('galilean_robots').value, '1');
    assert.deepEqual(value('galilean_robot_silent'), { value: '0', labels: { robot: 'io' } });
    assert.ok(Number(value('process_cpu_seconds_total').value) > 0);
    assert.ok(Number(value('process_resident_memory_bytes').value) > 1e6);
    for (const family of families) {
      assert.match(family.name, /^[a-z_]+$/);
      assert.ok(family.help.endsWith('.'), family.name);
      assert.equal(family.type === 'COUNTER', family.name.endsWith('_total'), family.name);
    }
  });
});

/** Without fetch, which unpacks by itself. */
function raw(url, headers = {}) {
  return within(new Promise((resolve, reject) => request(url, { headers }, (response) => {
    const parts = [];
    response.on('data', (part) => parts.push(part)).on('end', () => resolve({ headers: response.headers, body: Buffer.concat(parts) }));
  }).on('error', reject).end()), () => `an answer from ${url}`);
}
