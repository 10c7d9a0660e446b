// SPDX-License-Identifier: BSD-3-Clause
// Programs that are killed or stand still, and what the others say.
import { setTimeout as sleep } from 'node:timers/promises';
import { disagreement } from '../stages/agreement.mjs';
import { anotherPush, startSmallTeam } from '../stages/small_team.mjs';
import { secondsUntil, secondsUntilEach, until } from '../table.mjs';

const robotOf = (robots, name) => robots.find((each) => each.name === name);
/** How long a laptop sleeps: the first of ten times longer than DDS waits for anybody, and briefly then. */
const ASLEEP_S = 12, BRIEFLY_S = 1.5, LONG_EACH = 10;
/** What is no older was heard now. */
const HEARD_S = 0.5;
/** When in a push the monitor is killed: at any time in it. */
const killAfter_ms = (number) => (7 * number) % 60;

const killRobots = async (stage) => {
  for (const robot of stage.robots.values()) robot.process.kill('SIGKILL');
  for (const robot of stage.robots.values()) await robot.exited;
};

/** What was answered before the monitor was killed is in the history, and of the newest push it tells what the robots run. */
async function historyAgrees({ monitor }, told) {
  if (told?.id) {
    const kept = await monitor.ask(`/api/pushes/${told.id}`);
    if (told.state === 'done' && kept.state !== 'done') throw new Error(`a push that was told to be done is ${kept.state}`);
  }
  let differs = [];
  const agrees = async () => {
    const { pushes: [newest] } = await monitor.ask('/api/pushes');
    const robots = await monitor.robots();
    differs = (newest?.replies ?? []).filter(({ robot, status }) => {
      const runs = robotOf(robots, robot).program_hash === newest.hash;
      return runs !== ['running', 'confirmed'].includes(status);
    });
    return differs.length === 0;
  };
  await until(agrees, 'the history to agree with what the robots run', 20).catch((error) => {
    throw new Error(`${error.message}: ${JSON.stringify(differs)}`);
  });
}

export const group = {
  name: 'process',
  setUp: (scope) => startSmallTeam(scope, { count: 5 }),
  rows: [
    {
      fault: 'Robot programs are killed', promised: 'The operator is told within 3 s that they are silent',
      unit: 's', limit: 3,
      make: killRobots,
      measure: (stage) => secondsUntilEach(stage.names, () => stage.monitor.robots(), (name, robots) => robotOf(robots, name).silent, 'silence', 20),
      mend: async (stage) => {
        for (const name of stage.names) stage.startRobot(name);
        await stage.well();
      },
    },
    {
      fault: 'Robot programs are killed and started again', promised: 'The team is whole again within 6 s',
      unit: 's', limit: 6,
      make: async (stage) => {
        await killRobots(stage);
        // Then what is heard is of the new ones.
        await until(async () => (await stage.monitor.robots()).every(({ age_s }) => age_s > 2 * HEARD_S), 'the dead to be quiet');
        for (const name of stage.names) stage.startRobot(name);
      },
      measure: (stage) => secondsUntilEach(stage.names, () => stage.monitor.robots(), (name, robots) => {
        const { silent, age_s } = robotOf(robots, name);
        return !silent && age_s < HEARD_S;
      }, 'a sign', 30),
      mend: (stage) => stage.well(),
    },
    {
      fault: 'The monitor is killed in a push, and started again', promised: 'Within 6 s it serves and tells how the push ended; what it answered is there, and it agrees with what robots run',
      unit: 's', limit: 6,
      make: async (stage, number) => {
        const before = (await stage.monitor.ask('/api/pushes')).pushes.length;
        const sent = stage.monitor.fetch('/api/push', { body: anotherPush() }).catch(() => undefined);
        await sleep(killAfter_ms(number));
        await stage.monitor.kill();
        const answer = await sent;
        return { before, told: await answer?.json().catch(() => undefined) };
      },
      measure: async (stage, { before, told }) => {
        const began_ms = performance.now();
        await stage.monitor.start();
        let missing;
        await until(async () => {
          const { pushes } = await stage.monitor.ask('/api/pushes');
          if (pushes.length < Math.min(before, 200)) throw new Error(`of ${before} pushes ${pushes.length} are left`);
          const robots = await stage.monitor.robots();
          const heard = robots.filter(({ silent, program_hash }) => !silent && program_hash).length;
          const running = pushes.find(({ state }) => state === 'running');
          missing = heard < stage.names.length ? `${heard} robots are heard` : running ? `push ${running.id} is running` : disagreement(pushes[0], robots);
          return !missing;
        }, () => `the history and the robots to agree: ${missing}`, 30, 30);
        const took_s = (performance.now() - began_ms) / 1000;
        for (const { program_name, problems } of await stage.monitor.robots())
          if (!['first.bhdl', 'pushed.bhdl'].includes(program_name)) throw new Error(`a robot runs '${program_name}': ${problems}`);
        await historyAgrees(stage, told);
        return took_s;
      },
      // All run one program again: what was interrupted may have reached some.
      mend: async (stage) => {
        if (stage.monitor.process.exitCode !== null || stage.monitor.process.signalCode !== null) await stage.monitor.start();
        const { id } = await stage.monitor.ask('/api/push', { body: anotherPush() });
        const { state } = await stage.monitor.ended(id);
        if (state !== 'done') throw new Error(`a push to all is ${state}`);
      },
    },
    {
      fault: `The laptop with the monitor sleeps, up to ${ASLEEP_S} s`, promised: 'Within 3 s of waking it tells of the present',
      unit: 's', limit: 3,
      make: async (stage, number) => {
        stage.monitor.process.kill('SIGSTOP');
        await sleep(1000 * (number % LONG_EACH === 0 ? ASLEEP_S : BRIEFLY_S));
        stage.monitor.process.kill('SIGCONT');
      },
      measure: (stage) => secondsUntil(async () => {
        const robots = await stage.monitor.robots();
        return robots.length === stage.names.length && robots.every(({ silent, age_s }) => !silent && age_s < 1);
      }, 'the monitor to tell of the present', 30),
      mend: async (stage) => {
        stage.monitor.process.kill('SIGCONT');
        await stage.well();
      },
    },
  ],
};
