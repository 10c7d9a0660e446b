// SPDX-License-Identifier: BSD-3-Clause
// scripts/faults.sh runs every file that it is given, tells what each says, and fails where one does.
import assert from 'node:assert/strict';
import { cpSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { folderWith, root, run } from './tools.mjs';

/** What a checkout says whose Node tests are these words of a shell, and in which order they ran. */
function faults(t, words, files) {
  const folder = folderWith(t, {
    'scripts/packages.sh': '#!/bin/sh\n',
    'scripts/node_tests.sh': `#!/bin/sh\necho "$1" >>order\n${words}\n`,
  });
  cpSync(`${root}scripts/faults.sh`, `${folder}/scripts/faults.sh`);
  const { status, stdout } = run(`${folder}/scripts/faults.sh`, files.map((name) => `tests/faults/${name}.test.mjs`));
  return { status, stdout, order: readFileSync(`${folder}/order`, 'utf8').trim().split('\n').map((file) => /(\w+)\.test\.mjs$/.exec(file)[1]) };
}

test('what needs the machine for itself comes first, one after another, and what waits comes after it', (t) => {
  const { status, stdout, order } = faults(t, 'echo "ok - $1"', ['disk', 'clock', 'network', 'motors', 'process']);
  assert.equal(status, 0, stdout);
  assert.deepEqual(order.slice(0, 2), ['clock', 'motors']);
  assert.deepEqual(order.slice(2).sort(), ['disk', 'network', 'process']);
  assert.deepEqual(stdout.trim().split('\n'), ['clock', 'motors', 'disk', 'network', 'process'].map((name) => `ok - tests/faults/${name}.test.mjs`));
});

for (const name of ['motors', 'disk'])
  test(`it fails where ${name} does`, (t) => {
    const { status, order } = faults(t, `case $1 in */${name}.*) exit 1 ;; esac`, ['motors', 'process', 'disk']);
    assert.equal(status, 1);
    assert.equal(order.length, 3);
  });
