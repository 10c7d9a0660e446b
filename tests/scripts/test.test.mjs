// SPDX-License-Identifier: BSD-3-Clause
// Which program of tests scripts/test.sh builds for a name, and which of its tests it runs.
import assert from 'node:assert/strict';
import { cpSync, existsSync, readFileSync, rmSync } from 'node:fs';
import { test } from 'node:test';
import { folderWith, root, run } from './tools.mjs';

/** Says how it was called, and does no more. */
const standIn = (name, rest = '') => `#!/bin/sh\necho "${name} $*" >>calls\n${rest}\n`;

/** A checkout with a few tests, with stand-ins for what builds them and for the programs that this makes. */
function checkout(t, files = {}) {
  const folder = folderWith(t, {
    'tests/core/CMakeLists.txt': 'galilean_test(core_test\n  SOURCES\n    clock_test.cpp\n    wire/reader_test.cpp\n  LINK galilean_core)\n',
    'tests/core/clock_test.cpp': '#include "core/stepped_clock.h"\nTEST(SteppedClock, StandsStill) {}\nTEST_F(ClockTest, Runs) {}\n',
    'tests/core/wire/reader_test.cpp': 'TEST(Reader, Reads) {}\n',
    'tests/robot/CMakeLists.txt': 'galilean_test(motor_test SOURCES motor/goal_test.cpp LINK galilean_robot)\n' +
      'galilean_test(perceptual_test SOURCES perceptual/look_test.cpp LINK galilean_robot)\n',
    'tests/robot/motor/goal_test.cpp': 'TEST_F(MoveToGoalTest, IsDrawn) { make("move_to_goal"); make("avoid_wall"); }\nTEST(Other, Is) {}\n',
    'tests/robot/perceptual/look_test.cpp': 'TYPED_TEST(LookTest, Sees) {}\n',
    'build/dev/build.ninja': '',
    ...Object.fromEntries(['core_test', 'motor_test', 'perceptual_test'].map((name) => [`build/dev/tests/${name}`, standIn(name)])),
    'bin/ninja': standIn('ninja'),
    'bin/cmake': standIn('cmake', 'touch build/dev/build.ninja'),
    ...files,
  });
  cpSync(`${root}scripts/test.sh`, `${folder}/scripts/test.sh`);
  return folder;
}

/** How test.sh ends there, and what it calls for that. */
function testSh(folder, ...words) {
  const { status, stdout, stderr } = run(`${folder}/scripts/test.sh`, words, { env: { ...process.env, PATH: `${folder}/bin:${process.env.PATH}` } });
  const calls = existsSync(`${folder}/calls`) ? readFileSync(`${folder}/calls`, 'utf8').trim().split('\n') : [];
  return { status, said: stdout + stderr, calls };
}

const builds = (program) => `ninja -C build/dev ${program}`;
const runs = (program, filter) => `${program} --gtest_brief=1${filter ? ` --gtest_filter=${filter}` : ''}`;
const filterOf = (...suites) => suites.map((suite) => `${suite}.*:*/${suite}.*`).join(':');

for (const [what, name, program, filter] of [
  ['a whole program', 'motor_test', 'motor_test', undefined],
  ['a file', 'tests/core/clock_test', 'core_test', filterOf('ClockTest', 'SteppedClock')],
  ['a file, with its extension', 'tests/core/wire/reader_test.cpp', 'core_test', filterOf('Reader')],
  ['a file, by its name alone', 'goal_test', 'motor_test', filterOf('MoveToGoalTest', 'Other')],
  ['a file, by what it tests', 'look', 'perceptual_test', filterOf('LookTest')],
  ['a class, whose suite is called so', 'move_to_goal', 'motor_test', 'MoveToGoal.*:MoveToGoalTest.*'],
  ['a class, by its header', 'stepped_clock', 'core_test', 'SteppedClock.*:SteppedClockTest.*'],
  ['a schema, by the name that programs call it by', 'avoid_wall', 'motor_test', filterOf('MoveToGoalTest', 'Other')],
  ['a test', 'MoveToGoalTest.IsDrawn', 'motor_test', 'MoveToGoalTest.IsDrawn'],
  ['tests, by a pattern', 'Stepped*.Stands*', 'core_test', 'Stepped*.Stands*'],
])
  test(`${what} is found: ${name}`, (t) => {
    const { status, calls, said } = testSh(checkout(t), name);
    assert.equal(status, 0, said);
    assert.deepEqual(calls, [builds(program), runs(program, filter)]);
  });

test('options go to the program, and a program that fails is a failure', (t) => {
  const folder = checkout(t, { 'build/dev/tests/core_test': standIn('core_test', 'exit 1') });
  const { status, calls } = testSh(folder, 'core_test', '--gtest_repeat=10');
  assert.equal(status, 1);
  assert.deepEqual(calls, [builds('core_test'), `${runs('core_test')} --gtest_repeat=10`]);
});

test('what was not configured yet is, and what does not build is told and not run', (t) => {
  const folder = checkout(t, { 'bin/ninja': standIn('ninja', 'echo "FAILED: clock_test.cpp.o"; exit 1') });
  rmSync(`${folder}/build/dev/build.ninja`);
  const { status, calls, said } = testSh(folder, 'core_test');
  assert.equal(status, 1);
  assert.deepEqual(calls, ['cmake --preset dev', builds('core_test')]);
  assert.match(said, /FAILED: clock_test\.cpp\.o/);
});

for (const name of ['no_such_test', 'NoSuchTest.Is', 'tests/core/http.test.mjs', 'tests/browser/map.test.mjs'])
  test(`${name} is no test of a program: it says so, and how other tests are run`, (t) => {
    const { status, calls, said } = testSh(checkout(t, { 'tests/core/http.test.mjs': '', 'tests/browser/map.test.mjs': '' }), name);
    assert.equal(status, 2);
    assert.deepEqual(calls, []);
    assert.ok(said.split('\n').includes(`test.sh: there is no test called ${name}`), said);
    for (const other of ['scripts/node_tests.sh FILE', 'scripts/browser_tests.sh FILE']) assert.ok(said.includes(other), said);
  });

test('a file that no program lists is named', (t) => {
  const { status, calls, said } = testSh(checkout(t, { 'tests/core/new_test.cpp': 'TEST(New, Is) {}\n' }), 'new_test');
  assert.notEqual(status, 0);
  assert.deepEqual(calls, []);
  assert.match(said, /no program lists tests\/core\/new_test\.cpp/);
});
