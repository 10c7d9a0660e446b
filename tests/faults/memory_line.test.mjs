// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { judgeMemory, lineThrough, memoryOf } from './memory_line.mjs';

const MB = 1 << 20;
const samples = (count, bytes) => Array.from({ length: count }, (_, index) => [10 * index, bytes(index)]);

test('a line goes through its points', () => {
  const { slope, at } = lineThrough([[0, 1], [1, 3], [2, 5]]);
  assert.ok(Math.abs(slope - 2) < 1e-12);
  assert.ok(Math.abs(at(10) - 21) < 1e-12);
});

test('memory that grows without end is found, under noise, and what a start takes is not', () => {
  const noise = (index) => ((index * 7919) % 13) * MB / 50;
  assert.equal(judgeMemory(samples(720, (index) => 50 * MB + noise(index))).flat, true);
  assert.equal(judgeMemory(samples(720, (index) => 50 * MB + noise(index) + Math.min(index, 100) * MB / 10)).flat, true);
  const leak = judgeMemory(samples(720, (index) => 50 * MB + noise(index) + index * MB / 100));
  assert.equal(leak.flat, false);
  assert.ok(Math.abs(leak.bytes_per_hour - 3.6 * MB) < 0.1 * MB, `${leak.bytes_per_hour}`);
  assert.equal(judgeMemory(samples(5, () => MB)), undefined);
});

test('the memory of a process is told, and of one that has ended nothing', () => {
  assert.ok(memoryOf(process.pid) > 10 * MB);
  assert.equal(memoryOf(2 ** 30), undefined);
});
