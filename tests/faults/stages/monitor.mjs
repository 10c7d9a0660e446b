// SPDX-License-Identifier: BSD-3-Clause
// A monitor that can be killed and started again in its folder, at its port, and what is asked of it.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { freePort, Running } from '../../end_to_end/tools.mjs';
import { until } from '../table.mjs';

/** Longer than any answer is promised to take: then there is none. */
const NO_ANSWER_MS = 10_000;

export class Monitor {
  constructor(scope, { domain, cwd, env, port }) {
    Object.assign(this, { scope, domain, cwd, env, port, url: `http://127.0.0.1:${port}` });
  }

  static async start(scope, place) {
    const monitor = new this(scope, { ...place, port: await freePort() });
    await monitor.start();
    return monitor;
  }

  async start() {
    this.running = new Running(this.scope, ['monitor', '--listen', `127.0.0.1:${this.port}`, '--data', this.cwd], this);
    await this.running.line(/http:\/\/[0-9.]+:\d+/);
  }

  get process() {
    return this.running.process;
  }

  async kill() {
    this.process.kill('SIGKILL');
    await this.running.exited;
  }

  token(name = 'operator') {
    return readFileSync(join(this.cwd, `${name}.token`), 'utf8').trim();
  }

  /** Asks with `body` as JSON, or with `text` as it is. */
  fetch(path, { body, text = body && JSON.stringify(body), token = this.token() } = {}) {
    const headers = { authorization: `Bearer ${token}` };
    return fetch(`${this.url}${path}`, { headers, method: text ? 'POST' : 'GET', body: text, signal: AbortSignal.timeout(NO_ANSWER_MS) });
  }

  /** What it answers with 2xx, as JSON. */
  async ask(path, options) {
    const { status, text, json } = await this.answer(path, options);
    if (status >= 300) throw new Error(`${path}: ${status} ${text}`);
    return json();
  }

  /** What it answers, with any status: { status, text, json() }. */
  async answer(path, options) {
    const answer = await this.fetch(path, options);
    const text = await answer.text();
    return { status: answer.status, text, json: () => JSON.parse(text) };
  }

  /** Sends a command to all robots, such as hold. */
  order(kind) {
    return this.ask('/api/command', { body: { kind } });
  }

  async robots() {
    return (await this.ask('/api/status')).robots;
  }

  /** Until it hears so many robots, now, which run a program. */
  hears(count, patience_s) {
    const fresh = async () => {
      try {
        return (await this.robots()).filter(({ silent, age_s, program_hash }) => !silent && age_s < 1 && program_hash).length >= count;
      } catch { return false; } // it is not there yet
    };
    return until(fresh, `the monitor to hear ${count} robots`, patience_s, 30);
  }

  /** Until the push has ended; returns it. */
  ended(id, patience_s = 20) {
    return until(async () => {
      const push = await this.ask(`/api/pushes/${id}`);
      return push.state !== 'running' && push;
    }, `push ${id} to end`, patience_s, 20);
  }
}
