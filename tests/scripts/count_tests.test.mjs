// SPDX-License-Identifier: BSD-3-Clause
// What each runner reports, and how many tests of it have passed and failed.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { folderWith, root, run } from './tools.mjs';

const script = `${root}scripts/count_tests.sh`;
const count = (t, runner, log, status) => run(script, [runner, join(folderWith(t, { log }), 'log'), String(status)]);

const ctest = (summary, didNotRun = '') => `1/3 Test #1: Core.Counts, out of 9 ....   Passed    0.00 sec
${summary}

Total Test time (real) =   0.02 sec
${didNotRun}`;

const gtest = (ran, passed, rest = '') => `12: Running main() from ./googletest/src/gtest_main.cc
[==========] ${ran} from 1 test suite ran. (0 ms total)
[  PASSED  ] ${passed}
${rest}`;

const tap = ({ pass = 0, fail = 0, cancelled = 0, skipped = 0, todo = 0 }) => `TAP version 13
ok 1 - what it says
# tests ${pass + fail + cancelled + skipped + todo}
# suites 1
# pass ${pass}
# fail ${fail}
# cancelled ${cancelled}
# skipped ${skipped}
# todo ${todo}
# duration_ms 9.8
`;

const vitest = (files, tests) => ` ✓ tests/team/map.test.ts (3 tests) 4ms
\u001b[2m Test Files \u001b[22m ${files}
\u001b[2m      Tests \u001b[22m ${tests}
   Duration  15.17s
`;

const cases = [
  ['ctest', 'all pass', ctest('100% tests passed, 0 tests failed out of 3'), 0, '3 0'],
  ['ctest', 'one fails', ctest('67% tests passed, 1 tests failed out of 3'), 8, '2 1'],
  ['ctest', 'one is skipped, one disabled', ctest('100% tests passed, 0 tests failed out of 3',
    '\nThe following tests did not run:\n\t  2 - Wire.Meets (Skipped)\n\t  4 - Wire.Parts (Disabled)\n'), 0, '2 2'],
  ['ctest', 'one program is missing', ctest('67% tests passed, 1 tests failed out of 3',
    '\nThe following tests FAILED:\n\t  5 - wire_test_NOT_BUILT (Not Run)\n'), 8, '2 1'],
  ['ctest', 'every test is disabled', 'The following tests did not run:\n\t  4 - Wire.Parts (Disabled)\n', 0, '0 1'],
  ['ctest', 'no test is found', 'No tests were found!!!\n', 0, '0 1'],

  ['gtest', 'two programs pass', gtest('5 tests', '5 tests.') + gtest('1 test', '1 test.'), 0, '6 0'],
  ['gtest', 'one fails', gtest('5 tests', '4 tests.'), 8, '4 1'],
  ['gtest', 'one is skipped', gtest('5 tests', '4 tests.', '[  SKIPPED ] 1 test.\n'), 0, '4 1'],
  ['gtest', 'two are disabled', gtest('5 tests', '5 tests.', '  YOU HAVE 2 DISABLED TESTS\n'), 0, '5 2'],
  ['gtest', 'a program has no test', gtest('5 tests', '5 tests.') + gtest('0 tests', '0 tests.'), 0, '5 1'],
  ['gtest', 'a program dies among others', gtest('5 tests', '5 tests.'), 8, '5 1'],

  ['tap', 'two files pass', tap({ pass: 3 }) + tap({ pass: 2 }), 0, '5 0'],
  ['tap', 'one fails', tap({ pass: 3, fail: 1 }), 1, '3 1'],
  ['tap', 'a browser that does not start cancels the rest', tap({ pass: 32 }) + tap({ cancelled: 63 }), 1, '32 63'],
  ['tap', 'one is skipped and one left for later', tap({ pass: 3, skipped: 1, todo: 1 }), 0, '3 2'],
  ['tap', 'a file dies among others', tap({ pass: 3 }), 1, '3 1'],
  ['tap', 'nothing is reported', '', 0, '0 1'],

  ['vitest', 'all pass', vitest('42 passed (42)', '216 passed (216)'), 0, '216 0'],
  ['vitest', 'two fail', vitest('1 failed | 41 passed (42)', '2 failed | 214 passed (216)'), 1, '214 2'],
  ['vitest', 'all fail', vitest('1 failed (1)', '2 failed (2)'), 1, '0 2'],
  ['vitest', 'some are skipped and left for later', vitest('1 passed (1)', '2 passed | 1 skipped | 1 todo (4)'), 0, '2 2'],
  ['vitest', 'a file has no test', vitest('1 failed | 1 passed (2)', '2 passed (2)'), 1, '2 1'],
  ['vitest', 'there are no files', 'No test files found, exiting with code 1\n', 1, '0 1'],

  ['status', 'a command ends well', 'svelte-check found 0 errors\n', 0, '1 0'],
  ['status', 'a command fails', '# pass 7\n', 1, '0 1'],
];

for (const [runner, what, log, status, expected] of cases)
  test(`${runner}: ${what}`, (t) => assert.equal(count(t, runner, log, status).stdout, `${expected}\n`));

test('an unknown runner and a log that is not there are errors, and no count', (t) => {
  const unknown = count(t, 'jest', tap({ pass: 1 }), 0);
  assert.deepEqual([unknown.status, unknown.stdout], [2, '']);
  assert.match(unknown.stderr, /no runner 'jest'/);
  const missing = run(script, ['tap', '/nonexistent/log', '0']);
  assert.notEqual(missing.status, 0);
  assert.equal(missing.stdout, '');
});
