// SPDX-License-Identifier: BSD-3-Clause
// Clients of the monitor that cost it something. A page that is starved is in tests/browser/starved.test.mjs.
import { spawn } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { once } from 'node:events';
import { request } from 'node:http';
import { connect } from 'node:net';
import { setTimeout as sleep } from 'node:timers/promises';
import { connect as connectFoxglove } from '../../end_to_end/foxglove_client.mjs';
import { program } from '../../logs/tools.mjs';
import { commandTimes, crowded, p99 } from '../../tools/crowded.mjs';
import { within } from '../../tools/patience.mjs';
import { startSmallTeam } from '../stages/small_team.mjs';
import { Scope } from '../table.mjs';

const IDLE = 1000, SLOW = 200, WRONG_TOKENS = 30;
const VIEWERS = 1000, STALLED = 100, WATCHED_S = 1;
const QUESTIONS = 20;
const CHECKS = 50, FLOODS = 10, COMMANDS = 200;
const COSTLY = ['sensor_msgs/msg/CompressedImage', 'visualization_msgs/msg/MarkerArray'];

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

async function slowestAnswer(stage) {
  let slowest_s = 0;
  for (let question = 0; question < QUESTIONS; ++question) slowest_s = Math.max(slowest_s, await answerTime(stage));
  return slowest_s;
}

/** Connections that have been made, or refused. */
async function openMany(stage, count) {
  stage.sockets = Array.from({ length: count }, () => connect(stage.monitor.port, '127.0.0.1').on('error', () => {}));
  await Promise.all(stage.sockets.map((socket) => within(Promise.race([once(socket, 'connect'), once(socket, 'close')]), () => 'a connection')));
}

async function closeMany(stage) {
  clearInterval(stage.dripping);
  for (const socket of stage.sockets ?? []) socket.destroy();
  await stage.well();
}

/** The channels of what is live, but for pictures and markers. */
async function channels(stage) {
  const scope = new Scope();
  const { heard, channel } = connectFoxglove(scope, stage.monitor.url, { token: stage.monitor.token() });
  await channel('/io/state');
  await sleep(1000); // for what is advertised after that
  const ids = heard.advertise.flat().filter(({ schemaName }) => !COSTLY.includes(schemaName)).map(({ id }) => String(id));
  await scope.end();
  return ids;
}

/** What crowd_bench measures. */
async function crowd(stage, ids) {
  const child = spawn(program('crowd_bench'), [String(stage.monitor.port), `${VIEWERS}:${STALLED}`, String(WATCHED_S), ...ids],
    { stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '', problem = '';
  child.stdout.on('data', (data) => { said += data; });
  child.stderr.on('data', (data) => { problem += data; });
  await within(once(child, 'close'), () => 'the end of crowd_bench');
  if (!said) throw new Error(`crowd_bench failed: ${problem}`);
  return JSON.parse(said);
}

export const group = {
  name: 'clients',
  setUp: (scope) => startSmallTeam(scope),
  rows: [
    {
      fault: `${WRONG_TOKENS} wrong tokens come at once`, promised: "The operator's token is taken within 0.5 s, from the same address",
      unit: 's', limit: 0.5,
      make: ({ monitor }) => Promise.all(Array.from({ length: WRONG_TOKENS }, async () => {
        const { status } = await monitor.fetch('/api/command', { body: { kind: 'hold' }, token: randomBytes(32).toString('hex') });
        if (status < 400) throw new Error(`a wrong token was answered with ${status}`);
      })),
      measure: async ({ monitor }) => {
        const asked_ms = performance.now();
        await monitor.ask('/api/command', { body: { kind: 'resume' } });
        return (performance.now() - asked_ms) / 1000;
      },
    },
    {
      fault: `${IDLE} connections are opened, and say nothing`, promised: 'The next request is answered within 0.5 s',
      unit: 's', limit: 0.5,
      make: (stage) => openMany(stage, IDLE), measure: slowestAnswer, mend: closeMany,
    },
    {
      fault: `${SLOW} requests come at ten bytes a second`, promised: 'The next request is answered within 0.5 s',
      unit: 's', limit: 0.5,
      make: async (stage) => {
        await openMany(stage, SLOW);
        const text = 'GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nX-Long: ';
        let sent = 0;
        stage.dripping = setInterval(() => {
          for (const socket of stage.sockets) if (socket.writable) socket.write(text[sent] ?? 'x');
          ++sent;
        }, 100);
        await sleep(500);
      },
      measure: slowestAnswer, mend: closeMany,
    },
    {
      fault: `Of ${VIEWERS} viewers ${STALLED} stop reading`, promised: 'The others get 99 of 100 messages within 0.1 s',
      unit: 's', limit: 0.1,
      make: async (stage) => {
        stage.channels ??= await channels(stage);
      },
      measure: async (stage) => (await crowd(stage, stage.channels)).p99_ms / 1000,
      mend: (stage) => stage.well(),
    },
    {
      fault: `Beside ${VIEWERS} viewers of whom ${STALLED} stop reading, ${CHECKS} have a megabyte checked and ${FLOODS} ask without end`,
      promised: '99 of 100 commands are answered within 0.02 s',
      unit: 's', limit: 0.02,
      make: async (stage) => {
        stage.channels ??= await channels(stage);
      },
      measure: ({ monitor, channels: ids }) => crowded(
        { port: monitor.port, ids, crowdBench: program('crowd_bench'), viewers: VIEWERS, stalled: STALLED, checks: CHECKS, floods: FLOODS },
        async () => p99(await commandTimes(monitor.url, monitor.token(), COMMANDS)) / 1000,
      ),
      mend: (stage) => stage.well(),
    },
  ],
};
