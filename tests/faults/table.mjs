// SPDX-License-Identifier: BSD-3-Clause
// Faults are rows of tables, one table a group, in rows/. A row is
//   { fault, promised, unit, limit, needs?, make, measure, mend?, finish? }
// `make(stage, number)` makes the fault for the number-th time, from 0, and returns what `measure(stage, made)` needs. That
// returns the figure of which `promised` speaks, or one figure for each robot that the fault hit, and throws where more than
// the figure is wrong. A figure above `limit` breaks the promise. `mend(stage)` ends the fault, and waits until all is well
// again. `finish(stage)` ends what stays from time to time. `needs(stage)` returns a sentence where this machine lacks what
// the fault is made with.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { within } from '../tools/patience.mjs';
import { keep, summaryOf } from './summary.mjs';

/** How often tests make each fault. scripts/reliability.mjs makes them oftener. */
export const TIMES = 10;
/** After so many broken promises a fault is known well enough. */
export const BROKEN_ENOUGH = 5;
/** In a test a fault is tried no longer than this, so that all of them end in time. */
const TRIED_WITHIN_S = 150;
/** What does not end in this time is told, and keeps nothing else from ending. */
const ENDS_WITHIN_MS = 30_000;

/** What is started for some time, and how it ends: a test's context, outside of tests. */
export class Scope {
  #ends = [];

  after(end) {
    this.#ends.push(end);
  }

  /** Ends all, the newest first. */
  async end() {
    for (const end of this.#ends.splice(0).reverse()) {
      try {
        await within(Promise.resolve().then(end), () => 'the end of what was started', ENDS_WITHIN_MS);
      } catch (error) {
        console.error(error.message);
      }
    }
  }
}

/** Asks again, with pauses in which others work, until `question()` gives something truthy. `what` may be a function. */
export async function until(question, what, patience_s = 60, pause_ms = 10) {
  for (const end_ms = performance.now() + 1000 * patience_s; performance.now() < end_ms; await sleep(pause_ms)) {
    const answer = await question();
    if (answer) return answer;
  }
  throw new Error(`waited ${patience_s} s for ${typeof what === 'function' ? what() : what}`);
}

/** How many seconds it takes until `question()` gives something truthy. */
export async function secondsUntil(question, what, patience_s) {
  const began_ms = performance.now();
  await until(question, what, patience_s);
  return (performance.now() - began_ms) / 1000;
}

/** By item, how many seconds it takes until `isSo(item, answer)`. One `question()` serves them all. */
export async function secondsUntilEach(items, question, isSo, what, patience_s = 60) {
  const began_ms = performance.now(), taken = new Map();
  const missing = () => items.filter((each) => !taken.has(each));
  await until(async () => {
    const answer = await question();
    for (const each of missing()) if (isSo(each, answer)) taken.set(each, (performance.now() - began_ms) / 1000);
    return missing().length === 0;
  }, () => `${what} of ${missing().join(', ')}`, patience_s, 20);
  return items.map((each) => taken.get(each));
}

async function attempt(row, stage, tried, number) {
  try {
    const figures = [await row.measure(stage, await row.make(stage, number))].flat();
    tried.times += figures.length;
    for (const figure of figures) {
      tried.worst = Math.max(tried.worst ?? 0, figure);
      if (!(figure <= row.limit)) tried.broken.push(`${figure.toFixed(3)} ${row.unit}, and ${row.limit} are promised`);
    }
  } catch (error) {
    tried.times += 1;
    tried.broken.push(error.message);
  }
  await attemptTo(() => row.mend?.(stage), 'afterwards', tried);
}

async function attemptTo(end, when, tried) {
  try {
    await end();
  } catch (error) {
    tried.broken.push(`${when}: ${error.message}`);
  }
}

/**
 * Makes the fault so often, or for so many seconds. `first` is the number of the first time. Returns how often it was made,
 * the worst figure (null: none), what was broken, and how many seconds it took.
 */
export async function tryRow(row, stage, times, { first = 0, within_s = Infinity } = {}) {
  const began_ms = performance.now(), seconds = () => (performance.now() - began_ms) / 1000;
  const tried = { times: 0, worst: null, broken: [] };
  const lacks = await row.needs?.(stage);
  if (lacks) return { ...tried, broken: [`not tried: ${lacks}`], seconds: seconds() };
  while (tried.times < times && tried.broken.length < BROKEN_ENOUGH && seconds() < within_s) await attempt(row, stage, tried, first + tried.times);
  await attemptTo(() => row.finish?.(stage), 'at the end', tried);
  return { ...tried, seconds: seconds() };
}

/** In one line, how often a fault was tried and how that went. */
export const figuresOf = (row, { times, worst, seconds }) =>
  `tried ${times} times in ${seconds.toFixed(0)} s, worst ${worst === null ? 'none' : `${Number(worst.toFixed(3))} ${row.unit}`} of ${row.limit}`;

/** Registers a test for each row of `group`: { name, setUp(scope) → stage, rows }. What came of them is kept as JSON. */
export function testGroup(group) {
  const scope = new Scope(), summaries = [];
  let begun;
  after(async () => {
    await scope.end();
    keep(group.name, summaries);
  });
  for (const row of group.rows) {
    test(`${group.name}: ${row.fault}. ${row.promised}`, { timeout: 2000 * TRIED_WITHIN_S }, async (t) => {
      const stage = await (begun ??= group.setUp(scope));
      const tried = await tryRow(row, stage, TIMES, { within_s: TRIED_WITHIN_S });
      summaries.push(summaryOf(group, row, tried));
      t.diagnostic(figuresOf(row, tried));
      assert.deepEqual(tried.broken, []);
      assert.ok(tried.times >= TIMES, `it was made ${tried.times} times in ${TRIED_WITHIN_S} s, and not ${TIMES} times`);
    });
  }
}
