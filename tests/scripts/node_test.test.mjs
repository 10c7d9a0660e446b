// SPDX-License-Identifier: BSD-3-Clause
// A file of Node tests is green only if it has tests, and all of them have run to their end.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { eventually } from '../tools/patience.mjs';
import { folderWith, root, run } from './tools.mjs';

/** What node_test.sh says of a file with this text. */
function fileOf(t, text, limit = 60) {
  const folder = folderWith(t, { 'probe.test.mjs': `import { before, describe, test } from 'node:test';\n${text}\n` });
  const { NODE_TEST_CONTEXT, ...env } = process.env; // a test file that is run by another's runner reports to it
  return run(`${root}scripts/node_test.sh`, [join(folder, 'probe.test.mjs')], { env: { ...env, GALILEAN_TEST_LIMIT: String(limit) } });
}

test('a file of tests is run, and is red when one of them is', (t) => {
  assert.equal(fileOf(t, "test('good', () => {});").status, 0);
  const bad = fileOf(t, "test('good', () => {}); test('bad', () => { throw new Error(); });");
  assert.equal(bad.status, 1);
  assert.match(bad.stdout, /^# fail 1$/m);
  assert.doesNotMatch(bad.stdout, /probe\.test\.mjs ended/);
});

for (const [what, text, words] of [
  ['has no test', '', /registered no test/],
  ['has a suite without one', "describe('empty', () => {});", /registered no test/],
  ['leaves before its tests are over', "test('good', () => {}); test('leaves', () => process.exit(0)); test('never', () => {});", /ended before its tests did/],
  ['waits for what never comes, outside of tests', "test('good', () => {}); await new Promise(() => {});", /ended with exit code 13/],
])
  test(`a file that ${what} has failed, and is named`, (t) => {
    const { status, stdout } = fileOf(t, text);
    assert.equal(status, 1);
    assert.match(stdout, new RegExp(`^not ok - \\S+probe\\.test\\.mjs .*${words.source}.*\n# fail 1$`, 'm'));
  });

/** Whether a process does: one that has ended has no command line, even before somebody asks how it ended. */
function isRunning(pid) {
  try {
    return readFileSync(`/proc/${pid}/cmdline`, 'utf8') !== '';
  } catch { return false; }
}

test('a file that waits for ever is ended at its limit, with what it started', async (t) => {
  const { status, stdout } = fileOf(t, `import { spawn } from 'node:child_process';
    test('waits', () => new Promise((resolve) => setTimeout(resolve, 600_000)));
    console.log('started', spawn('sleep', ['600']).pid);`, 2);
  assert.equal(status, 1);
  assert.match(stdout, /^not ok - \S+probe\.test\.mjs was ended after \d+ s, the limit is 2 s/m);
  const [, pid] = /started (\d+)/.exec(stdout);
  await eventually(() => !isRunning(pid), 10_000);
});

test('the tests run on Node 18', () => assert.match(process.version, /^v18\./));
