// SPDX-License-Identifier: BSD-3-Clause
// Disks that are full, or fail.
import { constants } from 'node:os';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { freshDomain } from '../../end_to_end/tools.mjs';
import { Monitor } from '../stages/monitor.mjs';
import { noSmallDisk } from '../stages/namespaces.mjs';
import { endTalk, lostAtTheEnd, recordings, recordUntilFull, recordUntilKilled } from '../stages/recorders.mjs';
import { noShim, Shim } from '../stages/shim.mjs';
import { MonitorOnSmallDisk } from '../stages/small_disk_monitor.mjs';
import { anotherPush, startSmallTeam } from '../stages/small_team.mjs';
import { secondsUntil, until } from '../table.mjs';

const { EIO, ENOSPC } = constants.errno;

async function setUp(scope) {
  const shims = {}, hasSmallDisk = !noSmallDisk();
  const stage = await startSmallTeam(scope, {
    envs: (cwd, state) => {
      shims.robots = new Shim(scope, cwd, 'robots', state);
      shims.monitor = new Shim(scope, cwd, 'monitor', hasSmallDisk ? join(cwd, 'disk') : cwd);
      return { robots: shims.robots.env, monitor: shims.monitor.env };
    },
    monitorOf: hasSmallDisk ? MonitorOnSmallDisk : Monitor,
  });
  // Recorders have a domain of their own: there are fewer domains than recordings.
  return { ...stage, shims, scope, recorders_domain: freshDomain() };
}

const ioOf = async ({ monitor }) => (await monitor.robots()).find(({ name }) => name === 'io');
const hashOf = async (stage) => (await ioOf(stage)).program_hash;

/** Robots tell their state ten times a second. */
const TOLD_BY_THEN_MS = 400;

/** Pushes. What was answered must be so: a push that was taken is in the history, and of one that was not, no robot has it. */
async function pushOnce(stage) {
  const before = await hashOf(stage), asked_ms = performance.now();
  const { status, text, json } = await stage.monitor.answer('/api/push', { body: anotherPush() });
  const took_s = (performance.now() - asked_ms) / 1000;
  if (status < 300) {
    stage.taken = json().id;
  } else if (status < 500) {
    throw new Error(`the push was answered with ${status}: ${text}`);
  } else {
    await sleep(TOLD_BY_THEN_MS);
    if (await hashOf(stage) !== before) throw new Error('io runs a program whose push was refused');
  }
  return took_s;
}

const historyProblem = async ({ monitor }) => (await monitor.ask('/api/status')).history_problem;
const historyIsWell = (stage) => {
  let problem;
  return until(async () => !(problem = await historyProblem(stage)), () => `the history to be well: ${problem}`, 20, 30);
};

async function settle(stage) {
  for (const shim of Object.values(stage.shims)) {
    shim.failWriting(0);
    shim.failSyncing(0);
  }
  stage.monitor.empty?.();
  await historyIsWell(stage);
  const { id } = await stage.monitor.ask('/api/push', { body: anotherPush() });
  const { state } = await stage.monitor.ended(id);
  if (state !== 'done') throw new Error(`a push to a sound disk is ${state}`);
  await until(async () => (await stage.monitor.ask('/api/status')).history_problem === '', 'the history to be well again', 20);
  if (stage.taken) await stage.monitor.ask(`/api/pushes/${stage.taken}`);
  stage.taken = undefined;
  await until(async () => !(await ioOf(stage)).problems.some((each) => /the next start does not know/.test(each)), 'io to keep its program again', 20);
}

/** How long it takes until the page and whoever reads the metrics are told what is wrong with the history's disk. */
const toldOfDisk = ({ monitor }, words) => secondsUntil(async () => {
  const { history_problem } = await monitor.ask('/api/status');
  const metrics = await (await monitor.fetch('/metrics')).text();
  return words.test(history_problem) && /^galilean_history_disk_well 0$/m.test(metrics);
}, `the monitor to tell of its disk: ${words}`, 20);

const reserveIs = ({ monitor }, there) => until(async () =>
  (await (await monitor.fetch('/metrics')).text()).includes(`galilean_history_reserve ${there}\n`), `the reserve to be ${there}`, 20);

const PUSH = { unit: 's', limit: 5, measure: pushOnce, mend: settle };

export const group = {
  name: 'disk',
  setUp,
  rows: [
    {
      fault: "The recorder's disk is full", promised: 'It says so and ends with 1, and all but the last 3 s can be read',
      unit: 's', limit: 3, needs: noSmallDisk,
      make: recordings(recordUntilFull),
      measure: (stage, recorded) => recorded.map(lostAtTheEnd),
      mend: endTalk,
    },
    {
      fault: 'The recorder is killed', promised: 'All but the last 3 s can be read',
      unit: 's', limit: 3,
      make: recordings(recordUntilKilled),
      measure: (stage, lost_s) => lost_s,
      mend: endTalk,
    },
    {
      fault: "The disk with the monitor's history is full", promised: 'A push is answered within 5 s: kept, or refused with no robot changed',
      ...PUSH, needs: noSmallDisk,
      make: (stage) => stage.monitor.fill(),
    },
    {
      fault: "Writing the monitor's history fails", promised: 'A push is answered within 5 s: kept, or refused with no robot changed',
      ...PUSH, needs: noShim,
      make: (stage, number) => stage.shims.monitor.failWriting(number % 2 === 0 ? EIO : ENOSPC),
    },
    {
      fault: "The monitor's history cannot be synced", promised: 'A push is answered within 5 s: kept, or refused with no robot changed',
      ...PUSH, needs: noShim,
      make: (stage) => stage.shims.monitor.failSyncing(EIO),
    },
    {
      fault: "The disk with the monitor's history is full", promised: 'Page and metrics tell within 1 s, and a push is kept by the 8 MB that were kept back',
      unit: 's', limit: 1, needs: noSmallDisk,
      make: async (stage) => {
        await reserveIs(stage, 1);
        stage.monitor.fill();
      },
      measure: async (stage) => {
        const took_s = await toldOfDisk(stage, /the disk of .* is full/);
        await pushOnce(stage);
        if (!stage.taken) throw new Error('a push was refused, though room is kept back for it');
        return took_s;
      },
      mend: settle,
    },
    {
      fault: "Writing the monitor's history fails", promised: 'Page and metrics tell within 1 s, though nobody pushes',
      unit: 's', limit: 1, needs: noShim,
      make: (stage, number) => stage.shims.monitor.failWriting(number % 2 === 0 ? EIO : ENOSPC),
      measure: (stage) => toldOfDisk(stage, /fails, so that pushes may be refused/),
      mend: settle,
    },
    {
      fault: "The monitor's history cannot be synced", promised: 'Page and metrics tell within 1 s, though nobody pushes',
      unit: 's', limit: 1, needs: noShim,
      make: (stage) => stage.shims.monitor.failSyncing(EIO),
      measure: (stage) => toldOfDisk(stage, /fails, so that pushes may be refused/),
      mend: settle,
    },
    {
      fault: 'A robot cannot write the program that it is to run after a crash', promised: 'The operator is told within 5 s of the push',
      unit: 's', limit: 5, needs: noShim,
      make: async (stage, number) => {
        stage.shims.robots.failWriting(number % 2 === 0 ? EIO : ENOSPC);
        const { id } = await stage.monitor.ask('/api/push', { body: anotherPush() });
        await stage.monitor.ended(id);
      },
      measure: (stage) => secondsUntil(async () => (await ioOf(stage)).problems.some((each) => /the next start does not know/.test(each)),
        'io to have the problem', 20),
      mend: settle,
    },
  ],
};
