// SPDX-License-Identifier: BSD-3-Clause
// A demo has passed only if it ended when it was asked to, well, and nothing in it broke.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { folderWith, root, run } from './tools.mjs';

const line = 'http://127.0.0.1:1/#token=1\n  io, ganymede run office_cleanup in scenario office; Ctrl-C ends all\n';
const log = '13:02:45.340 info io: start -> wander (error_bits[0] became 1)\n13:02:45.390 warning io: late\n';

for (const [what, ending, demo, io, words] of [
  ['ends by itself', 'early 0', line, log, /ended by itself, with exit code 0/],
  ['fails', '1', line, log, /ended with exit code 1/],
  ['loses a robot', '0', `${line}galilean-demo: io ended (killed by signal 11 (Segmentation fault)); the others go on. See io.log:\n    13:02\n`, log, /killed by signal 11[^]*13:02/],
  ['logs an error', '0', line, `${log}13:02:46.000 error io: no camera\n`, /io\.log:13:02:46.000 error io: no camera/],
  ['logs an exception', '0', line, `${log}terminate called after throwing an instance of 'std::bad_alloc'\n`, /io\.log:terminate called/],
])
  test(`a demo that ${what} has failed`, (t) => {
    const folder = folderWith(t, { 'demo.log': demo, '.galilean/run-7/io.log': io });
    const { status, stdout } = run(`${root}scripts/judge_demo.sh`, [folder, ending]);
    assert.equal(status, 1);
    assert.match(stdout, words);
    assert.match(stdout, /^# fail 1$/m);
  });

test('a demo without a fault has passed, and one without a log has not', (t) => {
  const folder = folderWith(t, { 'demo.log': line, '.galilean/run-7/io.log': log });
  assert.equal(run(`${root}scripts/judge_demo.sh`, [folder, '0']).stdout, 'ok - the demo ran without a fault\n# pass 1\n');
  assert.equal(run(`${root}scripts/judge_demo.sh`, [folderWith(t, { 'demo.log': line }), '0']).status, 1);
});
