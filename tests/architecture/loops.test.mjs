// SPDX-License-Identifier: BSD-3-Clause
// A loop over a part of a value that a function returns reads that part after the value is gone: C++20 keeps only the
// part's reference. Compilers do not warn of it, and the loop mostly finds nothing.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const root = new URL('../..', import.meta.url).pathname;
const sources = execFileSync(`${root}/scripts/sources.sh`, ['*.h', '*.cpp']).toString().split('\n').filter(Boolean);

/** `for (… : f(…).as_json()[…])` and `for (… : f(…).value())`. */
const DANGLING = /\bfor\s*\([^;{]*?[^:]:\s(?:[^;{]*\bas_json\(\)\s*\[|\s*[\w:.>-]+\([^()]*\)\.value\(\)\s*\))/;

test('no loop runs over a part of what is gone', () => {
  assert.ok(sources.length > 500);
  assert.deepEqual(sources.filter((file) => DANGLING.test(readFileSync(`${root}/${file}`, 'utf8'))), []);
});

test('such a loop is found', () => {
  for (const bad of ['for (const auto& each : get("/api/orders").as_json()["orders"])', 'for (auto& each : history.pushes(9).value())'])
    assert.match(bad, DANGLING);
  for (const good of ['for (auto& each : open_among(std::move(pushes).value()))', 'for (auto& each : pushes.value())', 'for (auto& each : list_in("/api/orders", "orders"))'])
    assert.doesNotMatch(good, DANGLING);
});
