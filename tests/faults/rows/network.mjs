// SPDX-License-Identifier: BSD-3-Clause
// A network that loses packets. Ten robots and the monitor are alone in it, and each robot is a trial.
import { spawn } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { setTimeout as sleep } from 'node:timers/promises';
import { freshDomain, galileanBinary, scratchFolder } from '../../end_to_end/tools.mjs';
import { start } from '../../logs/tools.mjs';
import { within } from '../../tools/patience.mjs';
import { disagreement } from '../stages/agreement.mjs';
import { closeOf, endChild } from '../stages/children.mjs';
import { Monitor } from '../stages/monitor.mjs';
import { ownNetwork } from '../stages/namespaces.mjs';
import { anotherPush, PROGRAM, robotArguments } from '../stages/small_team.mjs';
import { secondsUntilEach, until } from '../table.mjs';

const ROBOTS = 10;
const PORT = 8080; // nobody else is in this network
const LIMIT_MS = 10_000;
/** DDS forgets whom it has not heard for ten seconds. */
const BRIEF_S = 4, LONG_S = 12;
const FETCHER = new URL('../stages/fetcher.mjs', import.meta.url).pathname;

/** Starts a command in the network, by `begin`; it ends with `scope`. */
function startWithin(scope, { network, domain, cwd }, command, args, begin = start) {
  const [first, ...rest] = [...network.within, command, ...args];
  const child = begin(first, rest, { cwd, env: { ...process.env, ROS_DOMAIN_ID: domain, XDG_STATE_HOME: cwd } });
  const closed = closeOf(child);
  scope.after(() => endChild(child, closed));
  return child;
}

/** A monitor in a network of its own, which a process there asks. */
class MonitorWithin extends Monitor {
  static async begin(scope, place) {
    const monitor = new MonitorWithin(scope, { ...place, port: PORT });
    monitor.child = startWithin(scope, place, galileanBinary, ['monitor', '--listen', `127.0.0.1:${PORT}`, '--data', place.cwd]);
    // Its answers are taken line by line, and not kept.
    monitor.asker = startWithin(scope, place, process.execPath, [FETCHER],
      (by, words, options) => spawn(by, words, { ...options, stdio: ['pipe', 'pipe', 'inherit'] }));
    monitor.asker.stdin.on('error', () => {});
    monitor.waiting = new Map();
    createInterface({ input: monitor.asker.stdout }).on('line', (line) => {
      const said = JSON.parse(line);
      monitor.waiting.get(said.number)?.(said);
      monitor.waiting.delete(said.number);
    });
    await until(() => /http:\/\/[0-9.]+:\d+/.test(monitor.child.text), () => `the monitor to serve; it said ${monitor.child.text}`);
    return monitor;
  }

  async fetch(path, { body, text = body && JSON.stringify(body), token = this.token() } = {}) {
    const number = this.asked = (this.asked ?? 0) + 1;
    const options = { headers: { authorization: `Bearer ${token}` }, method: text ? 'POST' : 'GET', body: text, limit_ms: LIMIT_MS };
    const answer = await within(new Promise((resolve) => {
      this.waiting.set(number, resolve);
      this.asker.stdin.write(`${JSON.stringify([number, `${this.url}${path}`, options])}\n`);
    }), () => `an answer to ${path}`, 2 * LIMIT_MS);
    if (answer.error) throw new Error(`${path}: ${answer.error}`);
    return { status: answer.status, text: () => Promise.resolve(answer.text) };
  }
}

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

const needs = ({ network }) => (network ? undefined : 'no network can be made: it needs unshare, nsenter, ip, nft, and root or namespaces of users');
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
