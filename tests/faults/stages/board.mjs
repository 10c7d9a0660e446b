// SPDX-License-Identifier: BSD-3-Clause
// The serial line between a simulated board and its robot, with somebody in between: tests/faults/serial_mutator.cpp.
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { setTimeout as sleep } from 'node:timers/promises';
import { testTool } from '../../logs/tools.mjs';
import { until } from '../table.mjs';
import { closeOf, endChild } from './children.mjs';

/** Wheels that are slower stand still: 3 mm/s. */
export const STILL_COUNTS_S = 16;
const MOVING_COUNTS_S = 200;
/** Wheels that stand for so long stand. */
const STANDS_MS = 300;
const KEPT_STATUSES = 1000;

const speed = ({ left, right }) => Math.max(Math.abs(left), Math.abs(right));
const moves = (status) => speed(status) > MOVING_COUNTS_S;

export class Board {
  constructor(scope, serial, link) {
    this.statuses = [];
    this.answers = [];
    this.process = spawn(testTool('serial_mutator'), [serial, link], { stdio: ['pipe', 'pipe', 'inherit'] });
    const closed = closeOf(this.process);
    this.process.stdin.on('error', () => {}); // it has ended
    scope.after(() => endChild(this.process, closed, () => this.process.stdin.end()));
    createInterface({ input: this.process.stdout }).on('line', (line) => this.#heard(JSON.parse(line)));
  }

  #heard(said) {
    if (said.left === undefined) return this.answers.push(said);
    this.statuses.push(said);
    if (this.statuses.length > 2 * KEPT_STATUSES) this.statuses.splice(0, KEPT_STATUSES);
    return undefined;
  }

  ready() {
    return until(() => this.answers.some((each) => each.ready), 'serial_mutator to begin');
  }

  /** Does this to the line. Returns when, by the wall clock [ms]. */
  async order(words) {
    const before = this.answers.length;
    this.process.stdin.write(`${words}\n`);
    await until(() => this.answers.length > before, `serial_mutator to obey '${words}'`, 10, 1);
    return this.answers.at(-1).at_ms;
  }

  driving() {
    return until(() => this.statuses.length > 10 && this.statuses.slice(-10).every(moves) && Date.now() - this.statuses.at(-1).at_ms < 500,
      'the wheels to turn', 30);
  }

  /** How many seconds after this time the wheels stood still, for good. */
  async stillAfter(at_ms, patience_s = 5) {
    const stands = () => {
      const since = this.statuses.filter((each) => each.at_ms > at_ms);
      const last = since.findLastIndex((each) => speed(each) > STILL_COUNTS_S);
      const first = since[last + 1];
      return first && since.at(-1).at_ms - first.at_ms >= STANDS_MS ? first : undefined;
    };
    const { at_ms: stood_ms } = await until(stands, 'the wheels to stand still', patience_s);
    return (stood_ms - at_ms) / 1000;
  }

  /** How many seconds after this time the wheels stood for the last time, in so many seconds that follow. */
  async standsUntil(at_ms, watched_s) {
    await sleep(at_ms + 1000 * watched_s - Date.now());
    const since = this.statuses.filter((each) => each.at_ms > at_ms);
    if (since.length === 0 || !moves(since.at(-1))) throw new Error(`after ${watched_s} s the wheels do not turn`);
    const last = since.findLastIndex((each) => !moves(each));
    return last < 0 ? 0 : (since[last + 1].at_ms - at_ms) / 1000;
  }

  /** For how many seconds at a time the wheels stood since this time, in so many seconds that follow. */
  async longestStop(at_ms, watched_s) {
    await sleep(at_ms + 1000 * watched_s - Date.now());
    const since = this.statuses.filter((each) => each.at_ms > at_ms);
    if (since.length === 0) throw new Error(`in ${watched_s} s the board reported nothing`);
    let moved_ms = at_ms, stands = false, longest_ms = 0;
    for (const each of since) {
      stands ||= !moves(each);
      if (stands) longest_ms = Math.max(longest_ms, each.at_ms - moved_ms);
      if (!moves(each)) continue;
      moved_ms = each.at_ms;
      stands = false;
    }
    return longest_ms / 1000;
  }

  /** The fastest wheel since this time [counts/s]. */
  fastestSince(at_ms) {
    return Math.max(0, ...this.statuses.filter((each) => each.at_ms > at_ms).map(speed));
  }
}
