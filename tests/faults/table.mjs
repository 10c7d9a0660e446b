// SPDX-License-Identifier: BSD-3-Clause
// Faults are rows of tables, one table a group, in rows/. A row is
//   { fault, promised, unit, limit, needs?, make, measure, mend? }
// `make(stage, number)` makes the fault for the number-th time, from 0, and returns what `measure(stage, made)` needs. That
// returns the figure of which `promised` speaks, or one figure for each robot that the fault hit, and throws where more than
// the figure is wrong. A figure above `limit` breaks the promise. `mend(stage)` ends the fault, and waits until all is well
// again. `needs(stage)` returns a sentence where this machine lacks what the fault is made with.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';

/** How often tests make each fault. scripts/reliability.mjs makes them oftener. */
export const TIMES = 10;
/** After so many broken promises a fault is known well enough. */
export const BROKEN_ENOUGH = 5;

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
        await end();
      } catch (error) {
        console.error(error.message);
      }
    }
  }
}

/** Asks again, with pauses in which others work, until `question()` gives something truthy. */
export async function until(question, what, patience_s = 60, pause_ms = 10) {
  for (const end_ms = performance.now() + 1000 * patience_s; performance.now() < end_ms; await sleep(pause_ms)) {
    const answer = await question();
    if (answer) return answer;
  }
  throw new Error(`waited ${patience_s} s for ${what}`);
}

/** How many seconds it takes until `question()` gives something truthy. */
export async function secondsUntil(question, what, patience_s) {
  const began_ms = performance.now();
  await until(question, what, patience_s);
  return (performance.now() - began_ms) / 1000;
}

async function attempt(row, stage, tried) {
  try {
    const figures = [await row.measure(stage, await row.make(stage, tried.times))].flat();
    tried.times += figures.length;
    for (const figure of figures) {
      tried.worst = Math.max(tried.worst ?? 0, figure);
      if (!(figure <= row.limit)) tried.broken.push(`${figure.toFixed(3)} ${row.unit}, and ${row.limit} are promised`);
    }
  } catch (error) {
    tried.times += 1;
    tried.broken.push(error.message);
  }
  try {
    await row.mend?.(stage);
  } catch (error) {
    tried.broken.push(`afterwards: ${error.message}`);
  }
}

/** Makes the fault so often. Returns how often it was, the worst figure (null: none), and what was broken. */
export async function tryRow(row, stage, times) {
  const tried = { times: 0, worst: null, broken: [] };
  const lacks = await row.needs?.(stage);
  if (lacks) return { ...tried, broken: [`not tried: ${lacks}`] };
  while (tried.times < times && tried.broken.length < BROKEN_ENOUGH) await attempt(row, stage, tried);
  return tried;
}

/** Registers a test for each row of `group`: { name, setUp(scope) → stage, rows }. */
export function testGroup({ name, setUp, rows }) {
  const scope = new Scope();
  let stage;
  before(async () => {
    stage = await setUp(scope);
  });
  after(() => scope.end());
  for (const row of rows) {
    test(`${name}: ${row.fault}. ${row.promised}`, { timeout: 300_000 }, async (t) => {
      const { times, worst, broken } = await tryRow(row, stage, TIMES);
      t.diagnostic(`tried ${times} times, worst ${worst?.toFixed(3)} ${row.unit} of ${row.limit}`);
      assert.deepEqual(broken, []);
      assert.ok(times >= TIMES, `${times} times`);
    });
  }
}
