// SPDX-License-Identifier: BSD-3-Clause
// A monitor and other programs in a network of their own, whose packets can be lost.
import { createInterface } from 'node:readline';
import { galileanBinary } from '../../end_to_end/tools.mjs';
import { start } from '../../logs/tools.mjs';
import { until } from '../table.mjs';
import { Monitor } from './monitor.mjs';

const PORT = 8080; // nobody else is in this network
const LIMIT_MS = 10_000;
const FETCHER = new URL('./fetcher.mjs', import.meta.url).pathname;

/** Starts a command in the network; it ends with `scope`. */
export function startWithin(scope, { network, domain, cwd }, command, args) {
  const [first, ...rest] = [...network.within, command, ...args];
  const child = start(first, rest, { cwd, env: { ...process.env, ROS_DOMAIN_ID: domain, XDG_STATE_HOME: cwd } });
  scope.after(() => {
    if (child.exitCode === null && child.signalCode === null) child.kill('SIGINT');
    return child.ended;
  });
  return child;
}

/** A monitor in a network of its own, which a process there asks. */
export class MonitorWithin extends Monitor {
  static async begin(scope, place) {
    const monitor = new MonitorWithin(scope, { ...place, port: PORT });
    monitor.child = startWithin(scope, place, galileanBinary, ['monitor', '--listen', `127.0.0.1:${PORT}`, '--data', place.cwd]);
    monitor.asker = startWithin(scope, place, process.execPath, [FETCHER]);
    monitor.asker.stdin.on('error', () => {});
    monitor.waiting = new Map();
    createInterface({ input: monitor.asker.stdout }).on('line', (line) => {
      const said = JSON.parse(line);
      monitor.waiting.get(said.number)?.(said);
      monitor.waiting.delete(said.number);
    });
    await until(() => /http:\/\/[0-9.]+:\d+/.test(monitor.child.text), `the monitor to serve; it said ${monitor.child.text}`);
    return monitor;
  }

  async fetch(path, { body, token = this.token() } = {}) {
    const number = this.asked = (this.asked ?? 0) + 1;
    const options = { headers: { authorization: `Bearer ${token}` }, method: body ? 'POST' : 'GET', body: body && JSON.stringify(body), limit_ms: LIMIT_MS };
    const answer = await new Promise((resolve) => {
      this.waiting.set(number, resolve);
      this.asker.stdin.write(`${JSON.stringify([number, `${this.url}${path}`, options])}\n`);
    });
    if (answer.error) throw new Error(`${path}: ${answer.error}`);
    return { ok: answer.status < 300, status: answer.status, text: () => Promise.resolve(answer.text) };
  }
}
