// SPDX-License-Identifier: BSD-3-Clause
// A second build, or one of another checkout, takes what the first one compiled, on a machine where nobody has set up
// ccache, as in CI.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';

const root = new URL('../..', import.meta.url).pathname;
const folder = mkdtempSync(join(tmpdir(), 'galilean-ccache-'));
after(() => rmSync(folder, { recursive: true, force: true }));

const [launcher] = /^find_program\(CCACHE[\s\S]*?^endif\(\)$/m.exec(readFileSync(join(root, 'CMakeLists.txt'), 'utf8'));
const { CCACHE_SLOPPINESS: ignored, ...own } = process.env;
const env = { ...own, CCACHE_DIR: join(folder, 'cache'), CCACHE_CONFIGPATH: '/dev/null' };
const run = (...words) => execFileSync(words[0], words.slice(1), { cwd: folder, env, encoding: 'utf8', timeout: 120_000 });

test('what is compiled with precompiled headers comes from the cache, also in another checkout', async () => {
  const checkouts = ['one', 'other'].map((name) => join(folder, name));
  for (const checkout of checkouts) {
    mkdirSync(checkout);
    writeFileSync(join(checkout, 'CMakeLists.txt'), `cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES C CXX)
${launcher}
add_executable(small small.cpp)
target_include_directories(small PRIVATE \${CMAKE_SOURCE_DIR})
target_precompile_headers(small PRIVATE <cstddef>)
`);
    writeFileSync(join(checkout, 'small.cpp'), 'int main() {}\n');
    run('cmake', '-G', 'Ninja', '-S', checkout, '-B', join(checkout, 'build'), '-DCMAKE_BUILD_TYPE=Release');
  }
  // Headers that were written in the same second are not trusted.
  for (const checkout of [checkouts[0], ...checkouts]) {
    await sleep(1100);
    run('ninja', '-C', join(checkout, 'build'));
    run('ninja', '-C', join(checkout, 'build'), '-t', 'clean');
  }
  const figures = Object.fromEntries(run('ccache', '--print-stats').trim().split('\n').map((line) => line.split('\t')));
  assert.equal(figures.could_not_use_precompiled_header, '0');
  assert.equal(Number(figures.direct_cache_hit) + Number(figures.preprocessed_cache_hit), 4, JSON.stringify(figures));
});
