// SPDX-License-Identifier: BSD-3-Clause
// Nothing moves unasked: robots that somebody attends are held after a fault of more than a second, and say why.
import { setTimeout as sleep } from 'node:timers/promises';
import { STILL_COUNTS_S } from '../stages/board.mjs';
import { startDriven } from '../stages/driven.mjs';
import { secondsUntilEach } from '../table.mjs';

const ROBOTS = 5;
const AWAY_S = 2, WATCHED_S = 1.5;
/** Longer than a robot needs to drive on that is let go on. */
const AGAIN_S = 2.5;

/** What a robot tells when the fault is over that holds it. */
const REASON = /^held: .*; resume it/;
const isOver = (problem) => REASON.test(problem) && !/when it is back/.test(problem);

/** Something is away for some seconds, and back: by robot, since when by the wall clock [ms]. */
const away = (take, give) => async (stage) => {
  await take(stage);
  await sleep(1000 * AWAY_S);
  return give(stage);
};
const order = (words) => (stage) => stage.each(({ board }) => board.order(words));
const signal = (name) => (stage) => stage.robots.map((robot) => {
  robot.signal(name);
  return Date.now();
});
const camera = (kind) => (stage) => stage.each(async ({ name }) => {
  await stage.part(kind, name, 'camera');
  return Date.now();
});

async function killRobots(stage) {
  signal('SIGKILL')(stage);
  await stage.each((robot) => robot.running.exited);
}
const startRobots = (stage) => stage.robots.map((robot) => {
  robot.start();
  return Date.now();
});

/** Until the operator is told why each robot is held. No wheel may turn then. */
async function heldAfter(stage, back_ms) {
  const told = await secondsUntilEach(stage.names, () => stage.monitor.robots(), (name, robots) => {
    const { held, problems } = robots.find((each) => each.name === name);
    return held && problems.some(isOver);
  }, 'the reason for which it is held', 20);
  await sleep(1000 * WATCHED_S);
  stage.robots.forEach(({ name, board }, index) => {
    const speed = board.fastestSince(back_ms[index]);
    if (speed > STILL_COUNTS_S) throw new Error(`${name} drove unasked: a wheel turned at ${speed.toFixed(0)} counts/s`);
  });
  return told;
}

const letGoOn = async (stage) => {
  await order('pass')(stage);
  await stage.monitor.order('resume');
  await stage.well();
};

const HELD = { unit: 's', limit: 2, promised: 'The operator is told within 2 s of its end why the robot is held, and no wheel turns', measure: heldAfter, mend: letGoOn };

export const group = {
  name: 'held',
  setUp: (scope) => startDriven(scope, { count: ROBOTS, attended: true }),
  rows: [
    { fault: `No byte comes through the serial line for ${AWAY_S} s`, ...HELD, make: away(order('cut'), order('pass')) },
    { fault: `The serial line is unplugged for ${AWAY_S} s`, ...HELD, make: away(order('unplug'), order('pass')) },
    { fault: `The board is away for ${AWAY_S} s, and starts anew`, ...HELD, make: away(order('cut'), order('restart')) },
    { fault: `The camera is unplugged for ${AWAY_S} s`, ...HELD, make: away(camera('break'), camera('mend')) },
    { fault: `The robot program stands still for ${AWAY_S} s`, ...HELD, make: away(signal('SIGSTOP'), signal('SIGCONT')) },
    {
      fault: 'The robot program is killed and started again', ...HELD,
      limit: 5, promised: 'The operator is told within 5 s of its start why the robot is held, and no wheel turns',
      make: away(killRobots, startRobots),
    },
    {
      fault: `The serial line was unplugged for ${AWAY_S} s, and an operator lets the robots go on`, promised: 'They drive within 2 s',
      unit: 's', limit: 2,
      make: async (stage) => {
        await heldAfter(stage, await away(order('unplug'), order('pass'))(stage));
        await stage.monitor.order('resume');
        return Date.now();
      },
      measure: (stage, resumed_ms) => Promise.all(stage.robots.map(({ board }) => board.standsUntil(resumed_ms, AGAIN_S))),
      mend: (stage) => stage.well(),
    },
  ],
};
