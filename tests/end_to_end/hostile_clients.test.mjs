// SPDX-License-Identifier: BSD-3-Clause
// Clients without a token that take more than their part of the monitor. An operator's commands are obeyed beside them.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { connect as openSocket } from 'node:net';
import { test } from 'node:test';
import { PATIENCE_MS, within } from '../tools/patience.mjs';
import { connect } from './foxglove_client.mjs';
import { eventually, freshDomain, galileanBinary, scratchFolder, startMonitor } from './tools.mjs';

/** A command was answered after up to 22 s beside one check. Most of this is for a machine that does other things. */
const MOST_MS = 250;
const PING = 0x89;
/** For so long a monitor runs that has enough memory, before it is told to end. */
const RUNS_FOR_MS = 5000;

/** A socket to the monitor that may be closed at any time; `heard` is what came. */
function raw(t, url, text = '') {
  const { hostname, port } = new URL(url);
  const socket = openSocket(Number(port), hostname);
  const client = { socket, heard: '' };
  client.closed = new Promise((resolve) => socket.on('close', resolve));
  client.open = new Promise((resolve) => socket.on('connect', resolve));
  socket.on('error', () => {}).on('data', (piece) => { client.heard += piece.toString('latin1'); });
  if (text) socket.write(text);
  t.after(() => socket.destroy());
  return client;
}

/** A client's frame of a WebSocket (RFC 6455, 5.2), masked with zeros. Requires: fewer than 126 bytes of payload. */
const frame = (opcode, payload) => Buffer.concat([Buffer.from([opcode, 0x80 | payload.length, 0, 0, 0, 0]), payload]);

const upgrade = 'GET /ws HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n'
  + 'Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n';

const metrics = async (url) => {
  const text = await (await fetch(`${url}/metrics`)).text();
  return (name) => Number(text.split('\n').find((line) => line.startsWith(`${name} `))?.slice(name.length + 1));
};
const reached = async (url, limit) => (await metrics(url))(`galilean_limit_reached_total{limit="${limit}"}`);

/** How long each of `count` holds took until it was answered [ms], in order of size. */
async function holds({ url, token }, count) {
  const taken = [];
  for (let i = 0; i < count; ++i) {
    const before = performance.now();
    const answer = await fetch(`${url}/api/command`, {
      method: 'POST', body: JSON.stringify({ kind: 'hold', targets: ['io'] }), headers: { authorization: `Bearer ${token('operator')}` },
    });
    assert.equal(answer.status, 200, await answer.text());
    taken.push(performance.now() - before);
  }
  return taken.sort((one, other) => one - other);
}

/** A program that takes long to check, as long as a file may be. */
function longProgram() {
  let text = 'states:\n';
  for (let i = 0; text.length < 400_000; ++i) text += `  state:\n    name: "s${i}"\n  end\n`;
  return JSON.stringify({ files: [{ path: 'long.bhdl', text: `${text}end\n` }] });
}

test('commands pass by checks, stalled clients and floods', async (t) => {
  const monitor = await startMonitor(t);
  const { url } = monitor;
  const body = longProgram();
  const ending = new AbortController();
  t.after(() => ending.abort());
  const checks = Array.from({ length: 50 }, () => fetch(`${url}/api/check`, { method: 'POST', body, signal: ending.signal })
    .then(async (answer) => ({ status: answer.status, after: answer.headers.get('retry-after'), text: await answer.text() }), () => null));
  for (let i = 0; i < 840; ++i) raw(t, url); // with those below, a thousand
  for (let i = 0; i < 100; ++i) raw(t, url, 'POST /api/check HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000\r\n\r\n{');
  let floods = true;
  const flooding = Array.from({ length: 10 }, async () => {
    while (floods) await fetch(`${url}/api/status`).then((answer) => answer.text(), () => {});
  });
  const taken = await holds(monitor, 100);
  floods = false;
  await Promise.all(flooding);
  assert.ok(taken[98] <= MOST_MS, `99 of 100 commands within ${MOST_MS} ms: ${taken.slice(-5)}`);
  const first = await within(Promise.race(checks), () => 'one of the checks to be answered');
  assert.ok([200, 503].includes(first?.status), JSON.stringify(first));
  if (first.status === 503) assert.ok(Number(first.after) > 0, first.text);
});

test('JSON of very many values, and very many ids, hold nobody up', async (t) => {
  const monitor = await startMonitor(t);
  const { url } = monitor;
  for (const text of [`[${'[],'.repeat(2_000_000)}[]]`, '['.repeat(4_000_000), `{"files":[${'{},'.repeat(1_000_000)}{}]}`]) {
    const asked = fetch(`${url}/api/check`, { method: 'POST', body: text });
    const taken = await holds(monitor, 10);
    assert.ok(taken.at(-1) <= 4 * MOST_MS, `${text.slice(0, 10)}: ${taken}`);
    assert.equal((await asked).status, 400);
  }
  const tooLong = await fetch(`${url}/api/check`, { method: 'POST', body: '['.repeat(16_000_000) }).then((answer) => answer.status, () => 'closed');
  assert.ok([413, 'closed'].includes(tooLong), String(tooLong)); // fetch may see the end before the answer
  const { client, next, socket } = connect(t, url);
  await next('serverInfo');
  socket.send(JSON.stringify({ op: 'unsubscribe', subscriptionIds: Array.from({ length: 15_000 }, (_, id) => id) }));
  await next('status', ({ message }) => /14999 more/.test(message));
  socket.send(JSON.stringify({ op: 'unsubscribe', subscriptionIds: Array.from({ length: 50_000 }, (_, id) => id) }));
  await next('status', ({ message }) => /more than 20000 values/.test(message));
  const taken = await holds(monitor, 10);
  assert.ok(taken.at(-1) <= 4 * MOST_MS, String(taken));
  client.close();
});

test('who floods with pings is closed', async (t) => {
  const { url } = await startMonitor(t);
  const before = (await metrics(url))('process_resident_memory_bytes');
  const flood = raw(t, url, upgrade);
  await eventually(() => flood.heard.includes('101 Switching Protocols'));
  const pings = Buffer.concat(Array.from({ length: 1000 }, () => frame(PING, Buffer.alloc(125))));
  const write = () => { if (!flood.socket.destroyed) flood.socket.write(pings, write); };
  write();
  await within(flood.closed, () => 'the monitor to close a WebSocket that sends very many pings');
  assert.ok(await reached(url, 'pings') >= 1);
  const grown = (await metrics(url))('process_resident_memory_bytes') - before;
  assert.ok(grown < 50e6, `${grown} bytes more`);
});

test('connections that only wait lock nobody out', async (t) => {
  const monitor = await startMonitor(t);
  const { url } = monitor;
  const waiting = Array.from({ length: 2100 }, () => raw(t, url));
  await within(Promise.all(waiting.map(({ open }) => open)), () => '2100 connections');
  const taken = await holds(monitor, 20);
  assert.ok(taken.at(-1) <= 4 * MOST_MS, String(taken));
  assert.equal((await fetch(`${url}/healthz`)).status, 200);
  assert.ok((await metrics(url))('galilean_connections_closed_total') >= 1);
  await monitor.monitor.line(/limit_reached_total\{limit="connections/);
});

test('what is no strict HTTP is answered once, and the connection closes', async (t) => {
  const { url } = await startMonitor(t);
  const hidden = 'GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n';
  for (const [fields, status] of [
    ['Host: localhost\r\nTransfer-Encoding: xchunked\r\n', 501],
    ['Host: localhost\r\nTransfer-Encoding: chunked\r\nContent-Length: 4\r\n', 400],
    ['Host: localhost\r\nHost: localhost\r\n', 400],
    ['X: a\r\n', 400],
    ['Host: localhost\r\nX: a\r\n b\r\n', 400],
    [`Host: localhost\r\n${'X: a\r\n'.repeat(200)}`, 431],
    [`Host: localhost\r\nX: ${'a'.repeat(20_000)}\r\n`, 431],
  ]) {
    const client = raw(t, url, `POST /healthz HTTP/1.1\r\n${fields}\r\n${hidden}`);
    client.socket.on('end', () => client.socket.end());
    await within(client.closed, () => `the end of a connection that sent ${fields.slice(0, 60)}`);
    assert.match(client.heard, new RegExp(`^HTTP/1\\.1 ${status} `), fields.slice(0, 60));
    assert.equal(client.heard.split('HTTP/1.1 ').length, 2, client.heard);
  }
  assert.ok((await metrics(url))('galilean_http_malformed_total') >= 5);
});

test('too few file descriptors end the start with a sentence', (t) => {
  const [data, domain] = [scratchFolder(t), freshDomain()];
  for (const most of [12, 100]) {
    const { status, signal, stdout, stderr } = spawnSync('bash', ['-c', `ulimit -n ${most} && exec "$@"`, 'bash', galileanBinary, 'monitor', '--listen', '127.0.0.1:0', '--data', data], {
      env: { ...process.env, ROS_DOMAIN_ID: domain }, encoding: 'utf8', timeout: PATIENCE_MS,
    });
    assert.equal(status, 1, `${signal} ${stdout}${stderr}`);
    assert.match(stderr, /^galilean-monitor: only \d+ files and connections .*ulimit -n 1024'\n$/);
  }
});

test('too little memory ends the monitor with a sentence, or it runs and ends when it is told to', (t) => {
  for (const most_kB of [300_000, 500_000, 700_000, 1_000_000]) {
    const { status, signal, stdout, stderr } = spawnSync('bash', ['-c', `ulimit -v ${most_kB} && exec "$@"`, 'bash', galileanBinary, 'monitor', '--listen', '127.0.0.1:0', '--data', scratchFolder(t)], {
      env: { ...process.env, ROS_DOMAIN_ID: freshDomain() }, encoding: 'utf8', timeout: RUNS_FOR_MS, killSignal: 'SIGTERM',
    });
    const said = `${most_kB} kB: ${status} ${signal} ${stdout}${stderr}`;
    if (status === 0) continue; // it ran, was told to end, and did
    assert.ok(signal === null || signal === 'SIGABRT', said);
    assert.match(stderr, /memory|no thread|map segment|cannot allocate|DDS cannot/i, said);
    assert.ok(stderr.trim().split('\n').length <= 2, said);
  }
});

test('a monitor whose file descriptors are used up says so, and goes on', async (t) => {
  const monitor = await startMonitor(t);
  const { url } = monitor;
  const { pid } = monitor.monitor.process;
  const most = readdirSync(`/proc/${pid}/fd`).length + 10;
  const limited = spawnSync('prlimit', ['--pid', String(pid), `--nofile=${most}:${most}`]);
  if (limited.status !== 0) return t.skip('prlimit is not there, or may not be used');
  const waiting = Array.from({ length: 100 }, () => raw(t, url));
  await monitor.monitor.line(/No file descriptor is free/);
  for (const { socket } of waiting) socket.destroy();
  await eventually(async () => (await fetch(`${url}/healthz`).catch(() => ({}))).status === 200);
  assert.ok(await reached(url, 'descriptors') >= 1);
});
