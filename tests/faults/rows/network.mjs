// SPDX-License-Identifier: BSD-3-Clause
// A network that loses packets. Ten robots and the monitor are alone in it, and each robot is a trial.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { freshDomain, galileanBinary, scratchFolder } from '../../end_to_end/tools.mjs';
import { disagreement } from '../stages/agreement.mjs';
import { MonitorWithin, startWithin } from '../stages/monitor_within.mjs';
import { NO_NETWORK, ownNetwork } from '../stages/namespaces.mjs';
import { anotherPush, PROGRAM, robotArguments } from '../stages/small_team.mjs';
import { secondsUntilEach, until } from '../table.mjs';

const ROBOTS = 10;
/** DDS forgets whom it has not heard for ten seconds. */
const BRIEF_S = 4, LONG_S = 15;

async function setUp(scope) {
  const network = await ownNetwork(scope);
  if (!network) return { network };
  const place = { network, domain: freshDomain(), cwd: scratchFolder(scope) };
  const file = join(place.cwd, 'first.bhdl');
  writeFileSync(file, PROGRAM);
  const names = Array.from({ length: ROBOTS }, (_, index) => `r${index}`);
  for (const name of names) startWithin(scope, place, galileanBinary, robotArguments(name, file));
  const monitor = await MonitorWithin.begin(scope, place);
  await monitor.hears(ROBOTS);
  return { network, names, monitor };
}

const needs = ({ network }) => (network ? undefined : NO_NETWORK);
const needsLosses = (stage) => needs(stage) ?? (stage.network.losesSome ? undefined : 'this kernel cannot lose one packet in five: it needs the module nft_numgen');
const mend = async ({ network, monitor }) => {
  network.mend();
  await monitor.hears(ROBOTS);
};
const cutOff = (seconds) => async ({ network }) => {
  network.cut();
  await sleep(1000 * seconds);
  network.mend();
};
const robotOf = (robots, name) => robots.find((each) => each.name === name);
const heardAgain = ({ monitor, names }) => secondsUntilEach(names, () => monitor.robots(), (name, robots) => {
  const robot = robotOf(robots, name);
  return !robot.silent && robot.age_s < 0.5;
}, 'a sign', 90);

/** Pushes, and returns the push once that has ended. */
async function pushed({ monitor }) {
  const { status, text, json } = await monitor.answer('/api/push', { body: anotherPush() });
  const said = json();
  const push = said.id ? said : said.pushed;
  if (!push?.id) throw new Error(`the push was answered with ${status}: ${text}`);
  return monitor.ended(push.id);
}

export const group = {
  name: 'network',
  setUp,
  rows: [
    {
      fault: 'One packet in five is lost', promised: 'A push to ten robots has ended within 5 s, and its answer says how',
      unit: 's', limit: 5, needs: needsLosses,
      make: ({ network }) => network.lose(20),
      measure: async (stage) => {
        const began_ms = performance.now();
        await pushed(stage);
        return (performance.now() - began_ms) / 1000;
      },
      mend,
    },
    {
      fault: 'The monitor is cut off from the robots', promised: 'The operator is told within 3 s that they are silent',
      unit: 's', limit: 3, needs,
      make: ({ network }) => network.cut(),
      measure: ({ monitor, names }) => secondsUntilEach(names, () => monitor.robots(), (name, robots) => robotOf(robots, name).silent, 'silence', 20),
      mend,
    },
    {
      fault: 'The monitor is cut off from the robots while it pushes', promised: 'Within 5 s of the end its history tells what each robot runs',
      unit: 's', limit: 5, needs,
      make: async (stage) => {
        stage.network.cut();
        const { id } = await pushed(stage);
        stage.network.mend();
        return id;
      },
      measure: async ({ monitor, names }, id) => secondsUntilEach(names, async () => ({ robots: await monitor.robots(), push: await monitor.ask(`/api/pushes/${id}`) }),
        (name, { robots, push }) => robotOf(robots, name).age_s < 0.5 && !disagreement(push, [robotOf(robots, name)]), 'what the history tells', 30),
      mend,
    },
    {
      fault: `The monitor is cut off from the robots for ${BRIEF_S} s`, promised: 'It tells of the present within 3 s of the end',
      unit: 's', limit: 3, needs, make: cutOff(BRIEF_S), measure: heardAgain, mend,
    },
    {
      fault: `The monitor is cut off from the robots for ${LONG_S} s, and DDS has forgotten them`, promised: 'It tells of the present within 35 s of the end',
      unit: 's', limit: 35, needs, make: cutOff(LONG_S), measure: heardAgain, mend,
    },
  ],
};
