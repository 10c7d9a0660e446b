// SPDX-License-Identifier: BSD-3-Clause
// A monitor and other programs in a network of their own, whose packets can be lost.
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { galileanBinary } from '../../end_to_end/tools.mjs';
import { start } from '../../logs/tools.mjs';
import { within } from '../../tools/patience.mjs';
import { until } from '../table.mjs';
import { closeOf, endChild } from './children.mjs';
import { Monitor } from './monitor.mjs';

const PORT = 8080; // nobody else is in this network
const LIMIT_MS = 10_000;
const FETCHER = new URL('./fetcher.mjs', import.meta.url).pathname;

/** Starts a command in the network, by `begin`; it ends with `scope`. */
export function startWithin(scope, { network, domain, cwd }, command, args, begin = start) {
  const [first, ...rest] = [...network.within, command, ...args];
  const child = begin(first, rest, { cwd, env: { ...process.env, ROS_DOMAIN_ID: domain, XDG_STATE_HOME: cwd } });
  const closed = closeOf(child);
  scope.after(() => endChild(child, closed));
  return child;
}

/** A monitor in a network of its own, which a process there asks. */
export class MonitorWithin extends Monitor {
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
    return { ok: answer.status < 300, status: answer.status, text: () => Promise.resolve(answer.text) };
  }
}
