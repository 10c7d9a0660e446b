// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { galilean, programs, scratchFolder } from './tools.mjs';

function contest(...options) {
  const { status, stdout, stderr } = galilean(['sim', '--headless', '--scenario', 'office', '--json', ...options]);
  assert.equal(status, 0, stderr);
  return JSON.parse(stdout);
}

test('the same seed gives the same hash, another seed another', () => {
  const options = ['--robots', '3', '--duration', '60', '--seed'];
  const first = contest(...options, '1');
  assert.equal(contest(...options, '1').hash, first.hash);
  assert.notEqual(contest(...options, '2').hash, first.hash);
});

for (const program of ['office_cleanup', 'sit_and_spin']) {
  test(`three robots with ${program} clean the office in ten minutes`, (t) => {
    const result = contest('--robots', '3', '--duration', '600', '--seed', '1', '--bhdl', `${programs}/${program}.bhdl`);
    t.diagnostic(`${result.deposited} deposited, ${result.collisions} collisions, score ${result.score}, ` +
      `longest stuck ${result.longest_stuck_s} s, ${(result.simulated_seconds / result.wall_seconds).toFixed(0)} simulated seconds a second`);
    assert.ok(Math.abs(result.simulated_seconds - 600) < 1);
    assert.ok(result.deposited >= 22, `${result.deposited} deposited`);
    assert.ok(result.collisions <= 100, `${result.collisions} collisions`);
    assert.ok(result.longest_stuck_s <= 6, `stuck for ${result.longest_stuck_s} s`);
  });
}

test('a hundred robots have places in an office that grows, and one more is refused', () => {
  const result = contest('--robots', '100', '--duration', '0.5');
  assert.equal(result.robots.length, 100);
  const { status, stderr } = galilean(['sim', '--headless', '--robots', '101']);
  assert.equal(status, 2);
  assert.match(stderr, /from 1 to 100 robots, not 101, because a DDS domain has room for no more/);
});

test('a scenario that is none ends with one clear line', (t) => {
  const file = `${scratchFolder(t)}/bad.json`;
  writeFileSync(file, '{"name": "bad", "arena": {"width_m": "wide"}}');
  for (const scenario of [file, 'no_such_scenario']) {
    const { status, stderr } = galilean(['sim', '--headless', '--scenario', scenario]);
    assert.equal(status, 2);
    assert.equal(stderr.trim().split('\n').length, 1, stderr);
    assert.ok(stderr.includes(scenario), stderr);
  }
});
