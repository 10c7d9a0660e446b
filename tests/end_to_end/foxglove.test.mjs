// SPDX-License-Identifier: BSD-3-Clause
// Foxglove's protocol, spoken with the peers that its authors wrote: @foxglove/ws-protocol's client,
// and the programs in @foxglove/ws-protocol-examples.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { within } from '../tools/patience.mjs';
import { connect, readerOf } from './foxglove_client.mjs';
import { eventually, getJson, root, startMonitor } from './tools.mjs';

const require = createRequire(`${root}tests/node/`);
const examples = require.resolve('@foxglove/ws-protocol-examples/package.json').replace('package.json', 'dist/cjs/ws-protocol-examples/src/index.js');

const asJson = (value) => new TextEncoder().encode(JSON.stringify(value));

test("the protocol's own client", async (t) => {
  const { url, token } = await startMonitor(t);

  for (const protocol of ['foxglove.websocket.v1', 'foxglove.sdk.v1'])
    await t.test(`${protocol}: channels, messages that their own schemas decode, and time`, async (inner) => {
      const { client, socket, next, channel } = connect(inner, url, { protocol });
      assert.deepEqual((await next('serverInfo')).capabilities.sort(), ['connectionGraph', 'parameters', 'parametersSubscribe', 'services', 'time']);
      assert.equal(socket.protocol, protocol);
      for (const topic of ['/io/state', '/team/map', '/tf', '/team/objects']) {
        const each = await channel(topic);
        assert.deepEqual([each.encoding, each.schemaEncoding], ['cdr', 'ros2idl']);
        const id = client.subscribe(each.id);
        const message = await next('message', ({ subscriptionId }) => subscriptionId === id);
        const decoded = readerOf(each).readMessage(message.data);
        if (topic === '/io/state') assert.equal(decoded.robot, 'io');
        if (topic === '/team/map') assert.equal(decoded.data.length, decoded.info.width * decoded.info.height);
        assert.ok(Math.abs(Number(message.timestamp) / 1e6 - Date.now()) < 60_000);
      }
      assert.ok(Math.abs(Number((await next('time')).timestamp) / 1e6 - Date.now()) < 60_000);
    });

  await t.test('who watches markers gets them', async (inner) => {
    const { client, next, channel } = connect(inner, url);
    const each = await channel('/team/markers');
    const id = client.subscribe(each.id);
    const { data } = await next('message', ({ subscriptionId }) => subscriptionId === id);
    const { markers } = readerOf(each).readMessage(data);
    assert.deepEqual([...new Set(markers.map((marker) => marker.ns))].sort(), ['names', 'robot_ellipses', 'robots']);
  });

  await t.test('services', async (inner) => {
    const viewer = connect(inner, url);
    const hold = await viewer.service('/galilean/hold');
    viewer.client.sendServiceCallRequest({ serviceId: hold.id, callId: 7, encoding: 'json', data: asJson({}) });
    assert.match((await viewer.next('serviceCallFailure')).message, /operator's token/);
    assert.match((await viewer.next('status')).message, /operator's token/);
    const operator = connect(inner, url, { token: token('operator') });
    const call = async (name, callId, request) => {
      const service = await operator.service(name);
      operator.client.sendServiceCallRequest({ serviceId: service.id, callId, encoding: 'json', data: asJson(request) });
    };
    await call('/galilean/hold', 8, { targets: ['io'] });
    const answer = await operator.next('serviceCallResponse', ({ callId }) => callId === 8);
    assert.ok(JSON.parse(new TextDecoder().decode(answer.data)).id);
    await eventually(async () => (await getJson(`${url}/api/status`)).robots[0].held);
    await call('/galilean/resume', 9, {});
    await eventually(async () => !(await getJson(`${url}/api/status`)).robots[0].held);
    await call('/galilean/hold', 10, { targets: ['europa'] });
    assert.match((await operator.next('serviceCallFailure')).message, /europa/);
  });

  await t.test('parameters are read, set and watched', async (inner) => {
    const { client, next } = connect(inner, url, { token: token('operator') });
    await next('serverInfo');
    client.getParameters([], 'all');
    const { parameters } = await next('parameterValues', ({ id }) => id === 'all');
    assert.deepEqual(parameters.map(({ name }) => name), ['/io.held', '/io.program_hash', '/io.program_name', '/team.filled', '/team.history_problem', '/team.leases', '/team.map_problem', '/team.program_hash', '/team.replayed']);
    client.subscribeParameterUpdates(['/io.held']);
    client.setParameters([{ name: '/io.held', value: true }]);
    const update = await next('parameterValues', ({ id, parameters: [first] }) => id === undefined && first.value === true);
    assert.deepEqual(update.parameters, [{ name: '/io.held', value: true }]);
    client.setParameters([{ name: '/io.program_name', value: 'x' }]);
    assert.match((await next('status')).message, /cannot be set/);
    client.setParameters([{ name: '/io.held', value: false }]);
    await eventually(async () => !(await getJson(`${url}/api/status`)).robots[0].held);
  });

  await t.test('the connection graph names writers, readers and services', async (inner) => {
    const { client, next } = connect(inner, url);
    await next('serverInfo');
    client.subscribeConnectionGraph();
    const graph = await next('connectionGraphUpdate', ({ publishedTopics }) => publishedTopics.length > 0);
    const ids = (list, name, key) => list.find((each) => each.name === name)?.[key];
    assert.deepEqual(ids(graph.publishedTopics, '/io/state', 'publisherIds'), ['io']);
    // A robot hears its own topic to learn of another one of its name.
    assert.deepEqual(ids(graph.subscribedTopics, '/io/state', 'subscriberIds').sort(), ['io', 'monitor']);
    assert.ok(ids(graph.advertisedServices, '/galilean/push', 'providerIds').length === 1);
  });
});

test('a client that asks and does not read is closed with code 1008 and the reason', async (t) => {
  const { url } = await startMonitor(t);
  const { socket, client, next } = connect(t, url);
  await next('serverInfo');
  const closed = new Promise((resolve) => socket.on('close', (code, reason) => resolve([code, String(reason)])));
  socket.pause();
  const id = 'x'.repeat(256 << 10);  // comes back with each answer
  for (let asked = 0; asked < 120; ++asked) client.getParameters([], id);  // more than 16 MB and what sockets take
  await eventually(async () => /^galilean_websocket_dismissed_total 1$/m.test(await (await fetch(`${url}/metrics`)).text()));
  socket.resume();
  const [code, reason] = await within(closed, () => 'the end of the connection');
  assert.equal(code, 1008);
  assert.match(reason, /too slow/);
});

test("the examples' programs as peers", async (t) => {
  const { url, token } = await startMonitor(t);
  const address = `${url.replace('http', 'ws')}/ws?token=${token('operator')}`;
  const run = (inner, args) => {
    const child = spawn(process.execPath, [examples, ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
    child.text = '';
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (text) => { child.text += text; });
    child.ended = new Promise((resolve) => child.on('close', resolve));
    inner.after(() => child.kill('SIGKILL'));
    return child;
  };

  await t.test('perf-test-client: every topic reaches it', async (inner) => {
    const peer = run(inner, ['perf-test-client', address]);
    const tick = async () => (await getJson(`${url}/api/status`)).robots[0].tick;
    await eventually(async () => /^galilean_websocket_subscriptions [1-9]/m.test(await (await fetch(`${url}/metrics`)).text()));
    const began = await tick();
    await eventually(async () => await tick() > began + 60);
    peer.kill('SIGINT');
    await within(peer.ended, () => `the client's end: ${peer.text}`);
    for (const topic of ['/io/state', '/io/program', '/io/catalog', '/tf', '/team/map', '/team/objects', '/team/markers'])
      assert.match(peer.text, new RegExp(`\\| ${topic} +\\| [1-9]`), peer.text);
  });

  await t.test('param-client: it toggles what is true or false, and the robot is held', async (inner) => {
    run(inner, ['param-client', address]);
    const held = async () => (await getJson(`${url}/api/status`)).robots[0].held;
    await eventually(held);
    await eventually(async () => !(await held()));
  });
});

test('the layout that ships names panels that it places, and topics of the demo', () => {
  const layout = JSON.parse(readFileSync(`${root}monitor/server/foxglove/three_robots.json`, 'utf8'));
  const placed = (node) => typeof node === 'string' ? [node, ...(layout.configById[node]?.tabs ?? []).flatMap((tab) => placed(tab.layout))]
    : [...placed(node.first), ...placed(node.second)];
  assert.deepEqual(placed(layout.layout).sort(), Object.keys(layout.configById).sort());
  const wire = readFileSync(`${root}docs/WIRE.md`, 'utf8');
  const topics = JSON.stringify(layout).match(/"\/[a-z]+[a-z/_]*/g).map((text) => text.slice(1))
    .filter((topic) => !topic.startsWith('/galilean/'));
  for (const topic of topics) {
    const described = topic.replace(/^\/(io|ganymede|callisto)/, '/NAME');
    assert.ok(wire.includes(described), `${topic} is not in WIRE.md`);
  }
});
