// SPDX-License-Identifier: BSD-3-Clause
// A file of tests that nobody runs, or that holds none, would pass whatever happens.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const root = new URL('../..', import.meta.url).pathname;
const read = (file) => readFileSync(`${root}/${file}`, 'utf8');
const filesNamed = (...patterns) =>
  execFileSync(`${root}/scripts/sources.sh`, patterns).toString().split('\n').filter((file) => file.startsWith('tests/'));

/** What stands in the words of a text between parentheses, spaces and quotes, such as names of files. */
const words = (text) => new Set(text.split(/[\s()"]+/));

test('every C++ file of tests holds one and is built', () => {
  const files = filesNamed('*_test.cpp');
  assert.ok(files.length > 50, files.join(' '));
  const built = new Map(filesNamed('CMakeLists.txt').map((file) => [file.replace('/CMakeLists.txt', ''), words(read(file))]));
  const isBuilt = (file) => [...built].some(([folder, names]) => file.startsWith(`${folder}/`) && names.has(file.slice(folder.length + 1)));
  assert.deepEqual(files.filter((file) => !isBuilt(file)), []);
  assert.deepEqual(files.filter((file) => !/^\s*(TYPED_)?TEST(_F|_P)?\(/m.test(read(file))), []);
});

test('every Node file of tests is run by a suite', () => {
  const suites = `${read('test.sh')}${read('scripts/browser_tests.sh')}`
    .replace(/(\S*)\{([^}]*)\}(\S*)/g, (_, before, choices, after) => choices.split(',').map((each) => before + each + after).join(' '));
  const files = filesNamed('*.test.mjs');
  assert.ok(files.length > 20, files.join(' '));
  const isRun = (file) => words(suites).has(file.replace(/[^/]+$/, '*.test.mjs'));
  assert.deepEqual(files.filter((file) => !isRun(file)), []);
});
