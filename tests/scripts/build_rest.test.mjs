// SPDX-License-Identifier: BSD-3-Clause
// What demo.sh does not wait for is built beside the demo, never longer than it, and says only what fails.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { eventually } from '../tools/patience.mjs';
import { folderWith, root, run } from './tools.mjs';

/** A checkout whose ninja has something to do, and then does this. */
function checkout(t, build) {
  const ninja = `#!/bin/sh\ncase " $* " in *" -n "*) echo '[1/1] c++'; exit ;; esac\necho "$*" >ninja.args\n${build}\n`;
  const folder = folderWith(t, { 'path/ninja': ninja, 'build/build.ninja': '' });
  cpSync(`${root}scripts`, `${folder}/scripts`, { recursive: true });
  return { folder, env: { ...process.env, PATH: `${folder}/path:${process.env.PATH}` } };
}

const rest = (folder) => `${folder}/scripts/build_rest.sh`;
const runs = (pid) => existsSync(`/proc/${pid}`);

test('all programs are built, the second command of the README first, and nothing is said', (t) => {
  const { folder, env } = checkout(t, 'echo done');
  const { status, stdout, stderr } = run(rest(folder), [], { env });
  assert.deepEqual([status, stdout, stderr], [0, '', '']);
  assert.match(readFileSync(`${folder}/ninja.args`, 'utf8'), /galilean-swap programs\n$/);
});

test('what does not compile is said', (t) => {
  const { folder, env } = checkout(t, "echo 'FAILED: top.o'; echo 'top.cpp:3: error: oops'; exit 1");
  const { status, stderr } = run(rest(folder), [], { env });
  assert.equal(status, 1);
  assert.match(stderr, /not all built[^]*FAILED: top\.o\ntop\.cpp:3: error: oops/);
});

test('it ends with the demo that it was started beside', async (t) => {
  const { folder, env } = checkout(t, 'echo $$ >ninja.pid; exec sleep 600');
  const demo = spawn('bash', ['-c', `setpriv --pdeathsig TERM ${rest(folder)} & exec sleep 600`], { env });
  t.after(() => demo.kill('SIGKILL'));
  await eventually(() => existsSync(`${folder}/ninja.pid`) && readFileSync(`${folder}/ninja.pid`, 'utf8').endsWith('\n'));
  const compiling = Number(readFileSync(`${folder}/ninja.pid`, 'utf8'));
  assert.ok(runs(compiling));
  demo.kill('SIGKILL');
  await eventually(() => !runs(compiling));
});

test('two builds in one folder wait for one another', async (t) => {
  const { folder, env } = checkout(t, 'test -e go || { touch early; exit 1; }');
  const other = spawn('flock', [`${folder}/build/lock`, 'sh', '-c', `touch ${folder}/held; while ! test -e ${folder}/go; do sleep 0.05; done`]);
  t.after(() => other.kill('SIGKILL'));
  await eventually(() => existsSync(`${folder}/held`));
  const second = spawn(rest(folder), [], { env });
  const ended = new Promise((resolve) => second.on('close', resolve));
  await Promise.race([ended, eventually(() => readFileSync('/proc/locks', 'utf8').includes('-> FLOCK'))]);
  assert.ok(!existsSync(`${folder}/early`));
  writeFileSync(`${folder}/go`, '');
  assert.equal(await ended, 0);
});
