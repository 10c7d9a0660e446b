// SPDX-License-Identifier: BSD-3-Clause
// What the wheels do. Five robots drive in simulation, and each fault hits all of them: each is a trial. They go on by
// themselves after a fault; those that are held are in held.mjs.
import { setTimeout as sleep } from 'node:timers/promises';
import { startDriven } from '../stages/driven.mjs';
import { secondsUntilEach } from '../table.mjs';

const ROBOTS = 5;
/** For how long a line is bad, or somebody is away. */
const WATCHED_S = 1;
const AGAIN_S = 2.5;

/** A fault of each line, and a second of it. Returns by robot when it began. */
const spoil = (order) => (stage) => stage.each(({ board }) => board.order(order));
/** Orders in the mutator's words that end what it does. */
const mendLines = async (stage) => {
  await stage.each(({ board }) => board.order('pass'));
  await stage.well();
};
const stillAfter = (stage, began) => Promise.all(stage.robots.map(({ board }, index) => board.stillAfter(began[index])));

const signalRobots = (name) => async (stage) => {
  await stage.well();
  return stage.robots.map((robot) => {
    robot.signal(name);
    return Date.now();
  });
};

/** The line is bad for a second and good again: how long until all drive without a pause. */
const drivesAfter = async (stage, began) => {
  await sleep(Math.max(...began) + 1000 * WATCHED_S - Date.now());
  const mended = await spoil('pass')(stage);
  return Promise.all(stage.robots.map(({ board }, index) => board.standsUntil(mended[index], AGAIN_S)));
};

const STANDS = { unit: 's', limit: 0.3, promised: 'The wheels stand still within 0.3 s' };

export const group = {
  name: 'motors',
  setUp: (scope) => startDriven(scope, { count: ROBOTS }),
  rows: [
    {
      fault: 'The robot program is killed', ...STANDS,
      make: signalRobots('SIGKILL'),
      measure: stillAfter,
      mend: async (stage) => {
        await stage.each((robot) => robot.running.exited);
        for (const robot of stage.robots) robot.start();
        await stage.well();
      },
    },
    {
      fault: 'The robot program stands still', ...STANDS,
      make: signalRobots('SIGSTOP'),
      measure: stillAfter,
      mend: async (stage) => {
        for (const robot of stage.robots) robot.signal('SIGCONT');
        await stage.well();
      },
    },
    {
      fault: 'No byte comes through the serial line', ...STANDS,
      make: spoil('cut'), measure: stillAfter, mend: mendLines,
    },
    {
      fault: 'The serial line is unplugged', ...STANDS,
      make: spoil('unplug'), measure: stillAfter, mend: mendLines,
    },
    {
      fault: 'No byte comes through the serial line', promised: 'The operator is told within 2 s',
      unit: 's', limit: 2,
      make: spoil('cut'),
      measure: (stage) => secondsUntilEach(stage.names, () => stage.monitor.robots(),
        (name, robots) => robots.find((each) => each.name === name).problems.length > 0, 'problems', 20),
      mend: mendLines,
    },
    {
      fault: 'One byte in fifty is lost, for a second', promised: 'The robot drives on within 2 s of its end',
      unit: 's', limit: 2,
      make: spoil('drop 20'), measure: drivesAfter, mend: mendLines,
    },
    {
      fault: 'One byte in fifty is garbled, for a second', promised: 'No wheel turns faster than 1.2 times as fast as in order',
      unit: 'times', limit: 1.2,
      make: spoil('garble 20'),
      measure: async (stage, began) => {
        await sleep(1000 * WATCHED_S);
        return stage.robots.map(({ board }, index) => board.fastestSince(began[index]) / stage.ordinary[index]);
      },
      mend: mendLines,
    },
    {
      fault: 'Bytes come in halves, with a pause of 4 ms', promised: 'The wheels turn on, without a stop of more than 0.1 s',
      unit: 's', limit: 0.1,
      make: spoil('halve'),
      measure: (stage, began) => Promise.all(stage.robots.map(({ board }, index) => board.longestStop(began[index], WATCHED_S))),
      mend: mendLines,
    },
    {
      fault: 'Nothing passes to the board for a second, and the robot is held meanwhile', promised: 'What waited then moves no wheel for more than 0.3 s',
      unit: 's', limit: 0.3,
      make: async (stage) => {
        await spoil('stall')(stage);
        await stage.monitor.order('hold');
        await sleep(1000 * WATCHED_S);
        return spoil('pass')(stage);
      },
      measure: stillAfter,
      mend: async (stage) => {
        await stage.each(({ board }) => board.order('pass'));
        await stage.monitor.order('resume');
        await stage.well();
      },
    },
    {
      fault: 'The board is started anew', promised: 'The robot drives on within 2 s',
      unit: 's', limit: 2,
      make: spoil('restart'),
      measure: (stage, began) => Promise.all(stage.robots.map(({ board }, index) => board.standsUntil(began[index], AGAIN_S))),
      mend: mendLines,
    },
    {
      fault: 'The camera is unplugged', promised: 'The wheels stand still within 1.5 s',
      unit: 's', limit: 1.5,
      make: (stage) => stage.each(async (robot) => {
        await stage.part('break', robot.name, 'camera');
        await stage.cameraGone(robot);
        return Date.now();
      }),
      measure: stillAfter,
      mend: async (stage) => {
        for (const { name } of stage.robots) await stage.part('mend', name, 'camera');
        await stage.well();
      },
    },
    {
      fault: 'The monitor is killed', promised: 'The wheels turn on, without a stop of more than 0.1 s',
      unit: 's', limit: 0.1,
      make: async (stage) => {
        await stage.monitor.kill();
        return Date.now();
      },
      measure: (stage, killed_ms) => Promise.all(stage.robots.map(({ board }) => board.longestStop(killed_ms, WATCHED_S))),
      mend: async (stage) => {
        await stage.monitor.start();
        await stage.well();
      },
    },
  ],
};
