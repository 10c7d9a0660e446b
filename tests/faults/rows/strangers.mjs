// SPDX-License-Identifier: BSD-3-Clause
// Others in the DDS domain who mean no good, or do not know what they do.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { galilean, galileanBinary, scratchFolder } from '../../end_to_end/tools.mjs';
import { testTool } from '../../logs/tools.mjs';
import { within } from '../../tools/patience.mjs';
import { closeOf, endChild } from '../stages/children.mjs';
import { Monitor } from '../stages/monitor.mjs';
import { anotherPush, PROGRAM, robotArguments, startSmallTeam } from '../stages/small_team.mjs';
import { until } from '../table.mjs';

/** A flood has so many figures, of a second each. */
const SECONDS_OF_FLOOD = 5;

const refusedMessages = async ({ monitor }) =>
  (await monitor.ask('/api/status')).refused_messages.reduce((sum, { messages }) => sum + messages, 0);
const hashOf = async ({ monitor }) => (await monitor.robots()).find(({ name }) => name === 'io').program_hash;

/** The greatest age of io, and the longest wait for an answer, in a second. */
async function worstOfASecond({ monitor }) {
  let worst_s = 0;
  for (const end_ms = performance.now() + 1000; performance.now() < end_ms; await sleep(50)) {
    const asked_ms = performance.now();
    const io = (await monitor.robots()).find(({ name }) => name === 'io');
    worst_s = Math.max(worst_s, io.age_s, (performance.now() - asked_ms) / 1000);
  }
  return worst_s;
}

/** A stranger floods the domain until endStranger, and the monitor hears it. */
async function flood(stage) {
  if (!stage.stranger) {
    const stranger = stage.stranger = spawn(testTool('wire_stranger'), [stage.domain], { stdio: ['pipe', 'pipe', 'inherit'] });
    stranger.stdin.on('error', () => {}); // it has ended
    const closed = closeOf(stranger);
    stage.scope.after(stage.endStranger = () => endChild(stranger, closed, () => stranger.stdin.end()));
    await within(once(stranger.stdout, 'data'), () => 'wire_stranger to begin', 30_000);
  }
  const before = await refusedMessages(stage);
  await until(async () => await refusedMessages(stage) > before, 'the monitor to hear the stranger', 60, 50);
}
async function endFlood(stage) {
  if (!stage.stranger) return;
  stage.stranger = undefined;
  await stage.endStranger();
  await stage.well();
}

/** Somebody's own monitor, which joins DDS under the name of the team's. */
async function impostor(stage) {
  if (!stage.impostor) {
    stage.impostor = await Monitor.start(stage.scope, { domain: stage.domain, cwd: scratchFolder(stage.scope) });
    await stage.impostor.hears(1);
  }
  return hashOf(stage);
}

export const group = {
  name: 'strangers',
  setUp: async (scope) => ({ ...await startSmallTeam(scope, { trusting: true }), scope }),
  rows: [
    {
      fault: 'A second robot of one name is started', promised: 'It says so and ends within 5 s, and the first runs on',
      unit: 's', limit: 5,
      make: () => performance.now(),
      measure: (stage, began_ms) => {
        const { status, stdout, stderr } = spawnSync(galileanBinary, [...robotArguments('io', stage.file), '--keep-nothing'],
          { env: { ...process.env, ROS_DOMAIN_ID: stage.domain }, encoding: 'utf8', timeout: 30_000 });
        if (status !== 1) throw new Error(`the second robot ended with ${status}: ${stdout}${stderr}`);
        return (performance.now() - began_ms) / 1000;
      },
      mend: (stage) => stage.well(),
    },
    {
      fault: 'A program comes from a process that is not the monitor', promised: 'The robot refuses it within 5 s, and says why',
      unit: 's', limit: 5,
      make: async (stage) => ({ before: await hashOf(stage), began_ms: performance.now() }),
      measure: async (stage, { before, began_ms }) => {
        writeFileSync(join(stage.cwd, 'strange.bhdl'), `; of a stranger\n${PROGRAM}`);
        const { status, stdout, stderr } = galilean(['swap', 'strange.bhdl', '--robot', 'io', '--direct'], stage);
        const took_s = (performance.now() - began_ms) / 1000;
        if (status !== 1 || !/rejected/.test(stdout)) throw new Error(`swap ended with ${status}: ${stdout}${stderr}`);
        if (await hashOf(stage) !== before) throw new Error('the robot runs what it refused');
        return took_s;
      },
    },
    {
      fault: 'A stranger invents 20,000 robots and writes numbers that are none, without end',
      promised: 'The monitor answers, and tells what it heard of the real robot, within 2 s',
      unit: 's', limit: 2,
      make: flood,
      measure: async (stage) => {
        const figures = [];
        for (let second = 0; second < SECONDS_OF_FLOOD; ++second) figures.push(await worstOfASecond(stage));
        return figures;
      },
      mend: endFlood,
    },
    {
      fault: 'The monitor is told to end while that stranger writes', promised: 'It ends within 5 s',
      unit: 's', limit: 5,
      make: flood,
      measure: async ({ monitor }) => {
        const asked_ms = performance.now();
        monitor.process.kill('SIGTERM');
        const { code, signal } = await monitor.running.exited;
        if (code !== 0) throw new Error(`the monitor ended with ${signal ?? code}`);
        return (performance.now() - asked_ms) / 1000;
      },
      mend: async ({ monitor }) => {
        if (monitor.process.exitCode === null && monitor.process.signalCode === null) await monitor.kill();
        await monitor.start();
      },
      finish: endFlood,
    },
    {
      fault: "Somebody's own monitor, with a key of its own, pushes a program", promised: 'The robot refuses it within 5 s, and runs on',
      unit: 's', limit: 5,
      make: impostor,
      measure: async (stage, before) => {
        const asked_ms = performance.now();
        const { status, text, json } = await stage.impostor.answer('/api/push', { body: anotherPush({ targets: ['io'] }) });
        const said = json(), push = said.id ? said : said.pushed;
        const took_s = (performance.now() - asked_ms) / 1000;
        if (push?.replies.find(({ robot }) => robot === 'io')?.status !== 'rejected') throw new Error(`the push was answered with ${status}: ${text}`);
        if (await hashOf(stage) !== before) throw new Error('the robot runs what it refused');
        return took_s;
      },
    },
  ],
};
