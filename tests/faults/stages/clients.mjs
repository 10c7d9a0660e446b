// SPDX-License-Identifier: BSD-3-Clause
// What clients do to a monitor, and how long others wait for it meanwhile. A stage is that of a small team.
import { request } from 'node:http';
import { connect } from 'node:net';
import { connect as connectFoxglove } from '../../end_to_end/foxglove_client.mjs';
import { galilean } from '../../end_to_end/tools.mjs';
import { within } from '../../tools/patience.mjs';
import { Scope, until } from '../table.mjs';

const QUESTIONS = 20;
/** How many orders to hold are timed. */
export const HOLDS = 20;
export const CHECKED_BYTES = 40_000;

/** How long the monitor takes to answer on a connection of its own [s]. */
async function answerTime({ monitor }) {
  const asked_ms = performance.now();
  const status = await within(new Promise((resolve, reject) => {
    request(`${monitor.url}/healthz`, { agent: false }, (response) => response.resume().on('end', () => resolve(response.statusCode)))
      .on('error', reject).end();
  }), () => 'an answer', 20_000);
  if (status !== 200) throw new Error(`/healthz answers ${status}`);
  return (performance.now() - asked_ms) / 1000;
}

export async function slowestAnswer(stage) {
  let slowest_s = 0;
  for (let question = 0; question < QUESTIONS; ++question) slowest_s = Math.max(slowest_s, await answerTime(stage));
  return slowest_s;
}

/** Connections that have been made, or refused. */
export async function openMany(stage, count) {
  stage.sockets = Array.from({ length: count }, () => connect(stage.monitor.port, '127.0.0.1').on('error', () => {}));
  const settled = (socket) => new Promise((resolve) => socket.once('connect', resolve).once('close', resolve));
  await within(Promise.all(stage.sockets.map(settled)), () => `${count} connections`);
}

export async function closeMany(stage) {
  clearInterval(stage.dripping);
  for (const socket of stage.sockets ?? []) socket.destroy();
  await stage.well();
}

/** A program that takes a while to check. */
export function longProgram() {
  let text = 'states:\n';
  for (let number = 0; text.length < CHECKED_BYTES; ++number) text += `  state: name: "s${number}" end\n`;
  return { files: [{ path: 'long.bhdl', text: `${text}end\n` }] };
}

/** The slowest of some orders that stop the robots [s]. */
export async function slowestHold({ monitor }) {
  let slowest_s = 0;
  for (let hold = 0; hold < HOLDS; ++hold) {
    const asked_ms = performance.now();
    await monitor.order('hold');
    slowest_s = Math.max(slowest_s, (performance.now() - asked_ms) / 1000);
  }
  return slowest_s;
}

const UPGRADE = 'GET /ws HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n' +
  'Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n';
/** A thousand pings of 125 bytes, masked with zeros (RFC 6455, 5.2). */
const PINGS = Buffer.concat(Array.from({ length: 1000 }, () => Buffer.concat([Buffer.from([0x89, 0x80 | 125, 0, 0, 0, 0]), Buffer.alloc(125)])));

export async function memory_MB({ monitor }) {
  const { text } = await monitor.answer('/metrics');
  return Number(/^process_resident_memory_bytes (\S+)$/m.exec(text)[1]) / 1e6;
}

/** Sends pings over a WebSocket until the monitor closes it. */
export async function floodWithPings({ monitor }) {
  const socket = connect(monitor.port, '127.0.0.1').on('error', () => {}).resume();
  const closed = new Promise((resolve) => socket.on('close', resolve));
  const flood = () => {
    if (!socket.destroyed) socket.write(PINGS, flood);
  };
  socket.write(UPGRADE, flood);
  await within(closed, () => 'the monitor to close a WebSocket that floods it', 30_000).finally(() => socket.destroy());
}

/** A WebSocket that somebody has opened with a token of his own. */
export async function openAsGuest(stage, number) {
  const { monitor } = stage, scope = new Scope(), name = `guest_${number}_${performance.now().toFixed(0)}`;
  stage.guest = { name, scope };
  const given = galilean(['tokens', 'add', name, '--role', 'operator', '--data', monitor.cwd], stage);
  if (given.status !== 0) throw new Error(`no token was added: ${given.stderr}`);
  const token = given.stdout.trim();
  await until(async () => (await monitor.answer('/api/status', { token })).json().may_steer, 'the token to be known', 20, 100);
  const { socket, next } = connectFoxglove(scope, monitor.url, { token });
  await next('serverInfo');
  return socket;
}
