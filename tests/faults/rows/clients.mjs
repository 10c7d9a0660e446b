// SPDX-License-Identifier: BSD-3-Clause
// Clients of the monitor that cost it something. A page that is starved is in tests/browser/starved.test.mjs.
import { randomBytes } from 'node:crypto';
import { setTimeout as sleep } from 'node:timers/promises';
import { galilean } from '../../end_to_end/tools.mjs';
import { program } from '../../logs/tools.mjs';
import { commandTimes, crowded, p99 } from '../../tools/crowded.mjs';
import { within } from '../../tools/patience.mjs';
import { CHECKED_BYTES, closeMany, floodWithPings, HOLDS, longProgram, memory_MB, openAsGuest, openMany, slowestAnswer, slowestHold } from '../stages/clients.mjs';
import { channels, crowd, STALLED, VIEWERS } from '../stages/crowd.mjs';
import { startSmallTeam } from '../stages/small_team.mjs';

const IDLE = 1000, SLOW = 200, WRONG_TOKENS = 30;
const CHECKS = 50, FLOODS = 10, COMMANDS = 200;
const BRACKETS = 4_000_000;

export const group = {
  name: 'clients',
  setUp: (scope) => startSmallTeam(scope),
  rows: [
    {
      fault: `${WRONG_TOKENS} wrong tokens come at once`, promised: "The operator's token is taken within 0.5 s, from the same address",
      unit: 's', limit: 0.5,
      make: ({ monitor }) => Promise.all(Array.from({ length: WRONG_TOKENS }, async () => {
        const { status } = await monitor.answer('/api/command', { body: { kind: 'hold' }, token: randomBytes(32).toString('hex') });
        if (status < 400) throw new Error(`a wrong token was answered with ${status}`);
      })),
      measure: async ({ monitor }) => {
        const asked_ms = performance.now();
        await monitor.order('resume');
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
      fault: `${CHECKS} programs of ${CHECKED_BYTES / 1000} kB are to be checked at once`, promised: `The slowest of ${HOLDS} orders to hold is answered within 0.25 s`,
      unit: 's', limit: 0.25,
      make: (stage) => {
        const program = longProgram();
        // Those beyond what waits are answered with 503.
        stage.checks = Array.from({ length: CHECKS }, () => stage.monitor.answer('/api/check', { body: program }).catch(() => undefined));
      },
      measure: slowestHold,
      mend: async (stage) => {
        await Promise.all(stage.checks);
        await stage.monitor.order('resume');
        await stage.well();
      },
    },
    {
      fault: `${BRACKETS / 1e6} million open brackets are sent as JSON`, promised: 'They are refused, and the next request is answered within 0.5 s',
      unit: 's', limit: 0.5,
      make: (stage) => {
        stage.refused = stage.monitor.answer('/api/check', { text: '['.repeat(BRACKETS) }).catch((error) => ({ error }));
      },
      measure: async (stage) => {
        const slowest_s = await slowestAnswer(stage);
        const { status, error } = await stage.refused;
        if (status !== 400) throw new Error(`the brackets were answered with ${status ?? error.message}`);
        return slowest_s;
      },
    },
    {
      fault: 'A WebSocket sends pings without end', promised: 'It is closed, and the monitor needs no more than 50 MB for that',
      unit: 'MB', limit: 50,
      make: memory_MB,
      measure: async (stage, before_MB) => {
        await floodWithPings(stage);
        return Math.max(0, await memory_MB(stage) - before_MB);
      },
      mend: (stage) => stage.well(),
    },
    {
      fault: 'A token is revoked whose bearer has a WebSocket open', promised: 'It is closed within 1 s',
      unit: 's', limit: 1,
      make: openAsGuest,
      measure: async (stage, socket) => {
        const closed = new Promise((resolve) => socket.on('close', resolve));
        const revoked = galilean(['tokens', 'revoke', stage.guest.name, '--data', stage.monitor.cwd], stage);
        if (revoked.status !== 0) throw new Error(`the token was not revoked: ${revoked.stderr}`);
        const revoked_ms = performance.now();
        await within(closed, () => 'the WebSocket to be closed', 20_000);
        return (performance.now() - revoked_ms) / 1000;
      },
      mend: (stage) => stage.guest.scope.end(),
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
