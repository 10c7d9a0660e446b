// SPDX-License-Identifier: BSD-3-Clause
// Others in the DDS domain who mean no good, or do not know what they do.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { galilean, galileanBinary } from '../../end_to_end/tools.mjs';
import { testTool } from '../../logs/tools.mjs';
import { within } from '../../tools/patience.mjs';
import { PROGRAM, robotArguments, startSmallTeam } from '../stages/small_team.mjs';
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

export const group = {
  name: 'strangers',
  setUp: (scope) => startSmallTeam(scope),
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
      make: async (stage) => {
        const before = await refusedMessages(stage);
        stage.stranger = spawn(testTool('wire_stranger'), [stage.domain], { stdio: ['pipe', 'pipe', 'inherit'] });
        stage.strangerEnded = once(stage.stranger, 'close');
        await within(once(stage.stranger.stdout, 'data'), () => 'wire_stranger to begin');
        await until(async () => await refusedMessages(stage) > before, 'the monitor to hear the stranger', 60, 50);
      },
      measure: async (stage) => {
        const figures = [];
        for (let second = 0; second < SECONDS_OF_FLOOD; ++second) figures.push(await worstOfASecond(stage));
        return figures;
      },
      mend: async (stage) => {
        stage.stranger?.stdin.end();
        if (stage.stranger) await within(stage.strangerEnded, () => 'the end of wire_stranger');
      },
    },
  ],
};
