// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { measuredOf, summaryOf } from './summary.mjs';

const row = { fault: 'It breaks', promised: 'Within 1 s', unit: 's', limit: 1, make: () => {}, measure: () => 0 };
const group = { name: 'things', rows: [row] };
const tried = { times: 10, worst: 0.5, broken: [], seconds: 3.14159 };

test('what is kept of a row is found again', () => {
  const summary = summaryOf(group, row, tried);
  assert.deepEqual(JSON.parse(JSON.stringify(summary)), summary);
  assert.deepEqual(summary, { group: 'things', fault: 'It breaks', promised: 'Within 1 s', unit: 's', limit: 1, times: 10, worst: 0.5, broken: [], seconds: 3.1 });
  assert.equal(measuredOf([group], [summary]).get(row), summary);
});

test('a row that was not tried, is no more or promises something else is left out', () => {
  const summary = summaryOf(group, row, tried);
  for (const other of [{ times: 0 }, { fault: 'It broke' }, { promised: 'Within 2 s' }, { group: 'other things' }])
    assert.equal(measuredOf([group], [{ ...summary, ...other }]).size, 0);
});
