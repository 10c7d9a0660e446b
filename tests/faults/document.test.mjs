// SPDX-License-Identifier: BSD-3-Clause
// The table of docs/RELIABILITY.md tells of every fault that is tried, and of no other, and its figures keep what is promised.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { table, told } from './document.mjs';
import { groups } from './groups.mjs';

const rows = groups.flatMap((group) => group.rows);
const key = ({ fault, promised }) => `${fault} | ${promised}`;

test('the document has a line for each fault, in their order', () => {
  assert.deepEqual([...told().keys()].slice(1), rows.map(key)); // the first is the head
});

test('no fault has two rows that promise the same, and each promise has a number', () => {
  assert.equal(new Set(rows.map(key)).size, rows.length);
  for (const { fault, promised, limit } of rows) {
    assert.match(promised, /\d/, fault);
    assert.ok(limit > 0, fault);
  }
});

test('what the document says was measured keeps the promise', () => {
  const known = told();
  for (const row of rows) {
    const { tried, worst } = known.get(key(row));
    if (tried === 'not tried yet') continue;
    assert.match(tried, /^\d+$/, row.fault);
    assert.ok(Number.parseFloat(worst) <= row.limit && !worst.includes('broken'), `${row.fault}: ${worst}`);
  }
});

test('what was not measured again keeps its figures, and what was has the new ones', () => {
  const group = { rows: [{ fault: 'A', promised: 'Within 1 s', unit: 's', limit: 1 }, { fault: 'B', promised: 'Within 2 s', unit: 's', limit: 2 }] };
  const before = new Map([['A | Within 1 s', { tried: '10', worst: '0.5 s' }]]);
  const measured = new Map([[group.rows[1], { times: 20, worst: 2.5, broken: ['2.500 s, and 2 are promised'] }]]);
  assert.deepEqual(table([group], measured, before).slice(2), ['| A | Within 1 s | 10 | 0.5 s |', '| B | Within 2 s | 20 | 2.5 s, **broken** |']);
});
