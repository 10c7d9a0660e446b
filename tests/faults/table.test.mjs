// SPDX-License-Identifier: BSD-3-Clause
// How rows are tried: what counts as a time, and what as a broken promise.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { figuresOf, Scope, secondsUntilEach, tryRow, until } from './table.mjs';

const row = (more) => ({ fault: 'It breaks', promised: 'Within 1 s', unit: 's', limit: 1, make: () => {}, measure: () => 0.5, ...more });

test('a fault is made so often, and its worst figure is told', async () => {
  const made = [];
  const { seconds, ...tried } = await tryRow(row({ make: (_, number) => made.push(number), measure: () => made.length / 10 }), {}, 10, { first: 20 });
  assert.deepEqual(tried, { times: 10, worst: 1, broken: [] });
  assert.ok(seconds >= 0);
  assert.deepEqual(made, [20, 21, 22, 23, 24, 25, 26, 27, 28, 29]);
});

test('each of several figures is a time', async () => {
  let made = 0;
  const tried = await tryRow(row({ make: () => { made += 1; }, measure: () => [0.1, 0.3, 0.2] }), {}, 10);
  assert.deepEqual([tried.times, tried.worst, made], [12, 0.3, 4]);
});

test('a figure above the limit, one that is none, and an error break the promise, and the fault is mended', async () => {
  for (const measure of [() => 1.5, () => NaN, () => { throw new Error('it fell over'); }]) {
    let mended = 0;
    const { times, broken } = await tryRow(row({ measure, mend: () => { mended += 1; } }), {}, 2);
    assert.deepEqual([times, broken.length, mended], [2, 2, 2]);
  }
  const { broken } = await tryRow(row({ mend: () => { throw new Error('it stays ill'); } }), {}, 1);
  assert.deepEqual(broken, ['afterwards: it stays ill']);
});

test('a row that promises in vain ends, and one that cannot be made says why and is broken', async () => {
  assert.equal((await tryRow(row({ measure: () => 2 }), {}, 1000)).times, 5);
  const { times, worst, broken } = await tryRow(row({ needs: () => 'there is no nft' }), {}, 10);
  assert.deepEqual([times, worst, broken], [0, null, ['not tried: there is no nft']]);
});

test('a row that takes too long ends, and what stays from time to time ends once', async () => {
  let finished = 0;
  const { times, broken } = await tryRow(row({ finish: () => { finished += 1; } }), {}, 10, { within_s: 0 });
  assert.deepEqual([times, broken, finished], [0, [], 1]);
  const failed = await tryRow(row({ finish: () => { throw new Error('it goes on'); } }), {}, 1);
  assert.deepEqual(failed.broken, ['at the end: it goes on']);
});

test('a line tells how often a fault was tried, with its worst figure', () => {
  assert.equal(figuresOf(row(), { times: 10, worst: 0.25, seconds: 3.4 }), 'tried 10 times in 3 s, worst 0.25 s of 1');
  assert.equal(figuresOf(row(), { times: 0, worst: null, seconds: 0 }), 'tried 0 times in 0 s, worst none of 1');
});

test('what was started last ends first, and one end that fails keeps no other from ending', async (t) => {
  const { error } = console;
  console.error = () => {};
  t.after(() => { console.error = error; });
  const ended = [], scope = new Scope();
  scope.after(() => ended.push('first'));
  scope.after(() => { throw new Error('it hangs'); });
  scope.after(() => ended.push('last'));
  await scope.end();
  assert.deepEqual(ended, ['last', 'first']);
});

test('what is waited for in vain is named', async () => {
  await assert.rejects(until(() => false, 'rain', 0.05), /waited 0\.05 s for rain/);
  await assert.rejects(until(() => false, () => 'snow', 0.05), /waited 0\.05 s for snow/);
  assert.equal(await until(() => 7, 'a number', 1), 7);
});

test('several are waited for at once, and those that do not come are named', async () => {
  let asked = 0;
  const taken = await secondsUntilEach(['io', 'ganymede'], () => ++asked, (name, count) => name === 'io' || count > 2, 'a word', 5);
  assert.equal(taken.length, 2);
  assert.ok(taken[0] < taken[1] && asked === 3, `${taken} ${asked}`);
  await assert.rejects(secondsUntilEach(['io', 'ganymede'], () => 0, (name) => name === 'io', 'a word', 0.05), /a word of ganymede/);
});
