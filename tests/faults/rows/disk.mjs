// SPDX-License-Identifier: BSD-3-Clause
// Disks that are full, or fail.
import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, statSync } from 'node:fs';
import { constants } from 'node:os';
import { join } from 'node:path';
import { freshDomain, scratchFolder } from '../../end_to_end/tools.mjs';
import { program, start, testTool } from '../../logs/tools.mjs';
import { within } from '../../tools/patience.mjs';
import { Monitor } from '../stages/monitor.mjs';
import { noSmallDisk, onSmallDisk } from '../stages/namespaces.mjs';
import { noShim, Shim } from '../stages/shim.mjs';
import { MonitorOnSmallDisk } from '../stages/small_disk_monitor.mjs';
import { anotherPush, startSmallTeam } from '../stages/small_team.mjs';
import { secondsUntil, until } from '../table.mjs';

const { EIO, ENOSPC } = constants.errno;
const RECORDERS = 5, RECORDERS_DISK_kB = 1500, KILLED_AT_BYTES = 1_000_000;

async function setUp(scope) {
  const shims = {};
  const stage = await startSmallTeam(scope, {
    envs: (cwd, state) => {
      shims.robots = new Shim(scope, cwd, 'robots', state);
      shims.monitor = new Shim(scope, cwd, 'monitor', join(cwd, 'disk'));
      return { robots: shims.robots.env, monitor: shims.monitor.env };
    },
    monitorOf: noSmallDisk() ? Monitor : MonitorOnSmallDisk,
  });
  // Recorders have a domain of their own: there are fewer domains than recordings.
  return { ...stage, shims, scope, recorders_domain: freshDomain() };
}

const ioOf = async ({ monitor }) => (await monitor.robots()).find(({ name }) => name === 'io');
const hashOf = async (stage) => (await ioOf(stage)).program_hash;

/** Pushes. What was answered must be so: a push that was taken is in the history, and of one that was not, no robot has it. */
async function pushOnce(stage) {
  const before = await hashOf(stage), asked_ms = performance.now();
  const answer = await stage.monitor.fetch('/api/push', { body: anotherPush() });
  const said = JSON.parse(await answer.text());
  const took_s = (performance.now() - asked_ms) / 1000;
  if (answer.ok) {
    stage.taken = said.id;
  } else if (answer.status < 500) {
    throw new Error(`the push was answered with ${answer.status}: ${said.detail}`);
  } else if (await hashOf(stage) !== before) {
    throw new Error('io runs a program whose push was refused');
  }
  return took_s;
}

async function settle(stage) {
  for (const shim of Object.values(stage.shims)) {
    shim.failWriting(0);
    shim.failSyncing(0);
  }
  stage.monitor.empty?.();
  const { id } = await stage.monitor.ask('/api/push', { body: anotherPush() });
  const { state } = await stage.monitor.ended(id);
  if (state !== 'done') throw new Error(`a push to a sound disk is ${state}`);
  await until(async () => (await stage.monitor.ask('/api/status')).history_problem === '', 'the history to be well again', 20);
  if (stage.taken) await stage.monitor.ask(`/api/pushes/${stage.taken}`);
  stage.taken = undefined;
  await until(async () => !(await ioOf(stage)).problems.some((each) => /the next start does not know/.test(each)), 'io to keep its program again', 20);
}

/** A recorder on a disk of its own, until that is full, and what can be read of the file then. */
function recordUntilFull(scope, domain) {
  const cwd = scratchFolder(scope), disk = join(cwd, 'disk');
  mkdirSync(disk);
  const script = `"$0" --out disk/run.mcap --domain ${domain} --picture-rate 0 --min-free 0 --compression none >&2
    echo "{\\"code\\": $?, \\"ended_ns\\": \\"$(date +%s%N)\\"}"; "$1" info disk/run.mcap --json`;
  const [command, ...args] = onSmallDisk(disk, RECORDERS_DISK_kB, ['bash', '-c', script, program('galilean-record'), program('galilean-log')]);
  const child = spawn(command, args, { cwd });
  const said = { stdout: '', stderr: '' };
  for (const stream of ['stdout', 'stderr']) child[stream].setEncoding('utf8').on('data', (text) => { said[stream] += text; });
  return within(new Promise((resolve) => child.on('close', () => resolve(said))), () => `a recorder's disk to be full: ${said.stderr}`);
}

/** A recorder that is killed while it writes, and how many seconds of its recording are lost at the end. */
async function recordUntilKilled(scope, domain) {
  const cwd = scratchFolder(scope), file = join(cwd, 'run.mcap');
  const recorder = start(program('galilean-record'), ['--out', file, '--domain', domain, '--picture-rate', '0', '--min-free', '0']);
  scope.after(() => recorder.kill('SIGKILL'));
  await until(() => statSync(file, { throwIfNoEntry: false })?.size > KILLED_AT_BYTES, 'the recorder to write', 30);
  recorder.kill('SIGKILL');
  const killed_ms = Date.now();
  await recorder.ended;
  const { stdout, stderr } = spawnSync(program('galilean-log'), ['info', file, '--json'], { encoding: 'utf8' });
  if (!stdout) throw new Error(`the recording cannot be read: ${stderr}`);
  return (killed_ms - Number(JSON.parse(stdout).end_ns) / 1e6) / 1000;
}

/** How many seconds of a recording are lost at its end. */
function lostAtTheEnd({ stdout, stderr }) {
  const end = stdout.indexOf('\n');
  const { code, ended_ns } = JSON.parse(stdout.slice(0, end));
  if (code !== 1) throw new Error(`the recorder ended with ${code}: ${stderr}`);
  if (!/cannot be written/.test(stderr)) throw new Error(`the recorder did not say why it ended: ${stderr}`);
  const info = JSON.parse(stdout.slice(end));
  return (Number(ended_ns) - Number(info.end_ns)) / 1e9;
}

const talk = (stage) => {
  stage.talker = start(testTool('wire_talker'), ['io', stage.recorders_domain]);
};
const endTalk = (stage) => {
  stage.talker.stdin.end();
  stage.talker.kill('SIGKILL');
  return stage.talker.ended;
};
const recordings = (record) => (stage) => {
  talk(stage);
  return Promise.all(Array.from({ length: RECORDERS }, () => record(stage.scope, stage.recorders_domain)));
};

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
