// SPDX-License-Identifier: BSD-3-Clause
// Every source says under which licence it is.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const root = new URL('../..', import.meta.url).pathname;
const kinds = ['*.h', '*.cpp', '*.ts', '*.mjs', '*.svelte', '*.css', '*.sh', '*.cmake', 'CMakeLists.txt'];

test('every source names its licence in its first lines', () => {
  const files = execFileSync(`${root}/scripts/sources.sh`, kinds).toString().split('\n').filter(Boolean);
  const named = (file) => readFileSync(`${root}/${file}`, 'utf8').split('\n', 2).some((line) => line.includes('SPDX-License-Identifier: BSD-3-Clause'));
  assert.deepEqual(files.filter((file) => !named(file)), []);
});
