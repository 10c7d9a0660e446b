// SPDX-License-Identifier: BSD-3-Clause
// A suite is green only if it was counted and nothing of it failed.
import assert from 'node:assert/strict';
import { cpSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { folderWith, root, run } from './tools.mjs';

/** What a suite says and counts, in a checkout whose counter of tests is this one. */
function suite(t, counter, command) {
  const checkout = folderWith(t, counter ? { 'scripts/count_tests.sh': `#!/bin/sh\n${counter}\n` } : {});
  cpSync(`${root}scripts`, `${checkout}/scripts`, { recursive: true, force: false });
  const { status, stdout } = run(`${checkout}/scripts/suite.sh`, ['probe', 'tap', 'sh', '-c', command]);
  return { status, stdout, counted: readFileSync(`${checkout}/build/test-logs/probe.count`, 'utf8') };
}

test('a suite that passes is green, one that fails is red', (t) => {
  const good = suite(t, '', "echo '# pass 2'");
  assert.deepEqual([good.status, good.counted], [0, '2 0\n']);
  assert.match(good.stdout, /^probe: +2 passed +0 failed/);
  const bad = suite(t, '', "echo '# pass 2'; exit 1");
  assert.deepEqual([bad.status, bad.counted], [1, '2 1\n']);
});

for (const [what, counter] of Object.entries({ dies: 'exit 1', 'is killed': 'echo 2 0; kill -9 $$', 'says nothing': 'exit 0', 'says no number': 'echo 2 passed' }))
  test(`a suite whose counter ${what} has failed`, (t) => {
    const { status, stdout, counted } = suite(t, counter, "echo '# pass 2'");
    assert.deepEqual([status, counted], [1, '0 1\n']);
    assert.match(stdout, /cannot be counted/);
  });
