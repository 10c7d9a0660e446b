// SPDX-License-Identifier: BSD-3-Clause
// Clocks that are set while programs run.
import { setTimeout as sleep } from 'node:timers/promises';
import { startDriven } from '../stages/driven.mjs';
import { noShim } from '../stages/shim.mjs';
import { secondsUntilEach } from '../table.mjs';

const HOUR_S = 3600;
const ROBOTS = 5;
const WATCHED_S = 1;
const settle = async (stage) => {
  stage.shims.robots.setClock(0);
  stage.shims.monitor.setClock(0);
  await stage.well();
};

const setRobots = (ahead_s) => (stage) => {
  stage.shims.robots.setClock(ahead_s);
  return Date.now();
};
const setMonitor = (ahead_s) => (stage) => stage.shims.monitor.setClock(ahead_s);
const goesOn = (stage, set_ms) => Promise.all(stage.robots.map(({ board }) => board.longestStop(set_ms, WATCHED_S)));

/** The greatest age of a robot that the monitor tells in a second. */
async function oldest(stage) {
  let oldest_s = 0;
  for (const end_ms = performance.now() + 1000 * WATCHED_S; performance.now() < end_ms; await sleep(50)) {
    for (const { name, age_s } of await stage.monitor.robots()) {
      if (age_s < 0) throw new Error(`${name} was heard in ${-age_s} s`);
      oldest_s = Math.max(oldest_s, age_s);
    }
  }
  return oldest_s;
}

const TURNS = { unit: 's', limit: 0.1, promised: 'The wheels turn on, without a stop of more than 0.1 s', needs: noShim, mend: settle };
const FRESH = { unit: 's', limit: 1, promised: 'No robot is told to be older than 1 s', needs: noShim, mend: settle };

export const group = {
  name: 'clock',
  setUp: (scope) => startDriven(scope, { count: ROBOTS, shim: true }),
  rows: [
    { fault: "The robots' clocks are set on by an hour", ...TURNS, make: setRobots(HOUR_S), measure: goesOn },
    { fault: "The robots' clocks are set back by an hour", ...TURNS, make: setRobots(-HOUR_S), measure: goesOn },
    {
      fault: "The robots' clocks are set on by an hour", promised: 'The operator is told within 2 s',
      unit: 's', limit: 2, needs: noShim,
      make: setRobots(HOUR_S),
      measure: (stage) => secondsUntilEach(stage.names, () => stage.monitor.robots(),
        (name, robots) => robots.find((each) => each.name === name).problems.some((each) => /ahead of/.test(each)), 'the problem', 20),
      mend: settle,
    },
    { fault: "The monitor's clock is set on by an hour", ...FRESH, make: setMonitor(HOUR_S), measure: oldest },
    { fault: "The monitor's clock is set back by an hour", ...FRESH, make: setMonitor(-HOUR_S), measure: oldest },
  ],
};
