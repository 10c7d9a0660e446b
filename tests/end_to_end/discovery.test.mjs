// SPDX-License-Identifier: BSD-3-Clause
// Programs find one another: without multicast, up to a hundred on one machine, and those of machines that are named.
import assert from 'node:assert/strict';
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { test } from 'node:test';
import { within } from '../tools/patience.mjs';
import { freshDomain, galilean, programs, Running, scratchFolder } from './tools.mjs';

const noMulticast = { CYCLONEDDS_URI: '<General><AllowMulticast>false</AllowMulticast></General>' };
/** Where the nth program of a machine hears of others, by the rules of DDS. */
const discoveryPort = (domain, nth) => 7410 + 250 * Number(domain) + 2 * nth;

async function bound(t, port, address) {
  const socket = createSocket('udp4');
  t.after(() => socket.close());
  socket.bind(port, address);
  await once(socket, 'listening');
  return socket;
}

/** A robot without a board and a camera, that has joined. */
async function startRobot(t, { domain, env }) {
  const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none', '--camera', 'shm:none'],
    { domain, env, cwd: scratchFolder(t) });
  await robot.line(/comm_port/);
}

test('the hundredth program on a machine finds the ninety-ninth, without multicast', async (t) => {
  const domain = freshDomain();
  for (let nth = 0; nth < 98; ++nth) await bound(t, discoveryPort(domain, nth));
  await startRobot(t, { domain, env: noMulticast });
  const top = galilean(['top', '--once'], { domain, env: noMulticast });
  assert.equal(top.status, 0, top.stdout + top.stderr);
  assert.match(top.stdout, /^.*I +io +\w+/m);
});

test('a program calls at the machines that GALILEAN_PEERS names', async (t) => {
  const domain = freshDomain();
  // Addresses of this machine that no program is told of otherwise.
  const peers = ['127.0.0.2', '127.0.0.3'];
  const calls = [];
  for (const peer of peers) calls.push(once(await bound(t, discoveryPort(domain, 0), peer), 'message'));
  await startRobot(t, { domain, env: { GALILEAN_PEERS: peers.join(',') } });
  for (const [bytes] of await within(Promise.all(calls), () => 'a call at each peer')) assert.equal(String(bytes.subarray(0, 4)), 'RTPS');
});
