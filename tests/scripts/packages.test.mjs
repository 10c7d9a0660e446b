// SPDX-License-Identifier: BSD-3-Clause
// Packages that cannot be fetched are said soon, with npm's own words; what is there is not fetched again.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { folderWith, root, run } from './tools.mjs';

const WANTED = JSON.stringify({ name: 'wants', version: '1.0.0', dependencies: { 'left-over': '1.0.0' } });
const LOCK = JSON.stringify({
  name: 'wants', version: '1.0.0', lockfileVersion: 3,
  packages: { '': { dependencies: { 'left-over': '1.0.0' } }, 'node_modules/left-over': { version: '1.0.0' } },
});

/** Where nothing answers. */
const env = { ...process.env, npm_config_registry: 'http://127.0.0.1:9/' };

test('without a network it ends with a sentence and an exit code', (t) => {
  const folder = folderWith(t, { 'package.json': WANTED, 'package-lock.json': LOCK });
  const { status, stdout, stderr } = run(`${root}scripts/packages.sh`, [folder], { env, timeout: 120_000 });
  assert.equal(status, 1);
  assert.equal(stdout, '');
  assert.match(stderr, /ECONNREFUSED[^]*packages\.sh: npm could not fetch the packages of .*connect this machine/);
});

test('packages that are there already are not asked for', (t) => {
  const folder = folderWith(t, { 'package.json': WANTED, 'package-lock.json': LOCK });
  run('bash', ['-c', `mkdir ${folder}/node_modules; touch -d '1 minute' ${folder}/node_modules/.package-lock.json`]);
  const { status, stderr } = run(`${root}scripts/packages.sh`, [folder], { env, timeout: 120_000 });
  assert.deepEqual([status, stderr], [0, '']);
});
