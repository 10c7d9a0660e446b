// SPDX-License-Identifier: BSD-3-Clause
// What docs/CI.md tells somebody with an empty repository to type works, and so does what its workflow types.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { galileanBinary, root } from './tools.mjs';

const page = readFileSync(join(root, 'docs/CI.md'), 'utf8');
const workflow = readFileSync(join(root, 'docs/ci/galilean.yml'), 'utf8');
const repository = mkdtempSync(join(tmpdir(), 'galilean-ci-'));
after(() => rmSync(repository, { recursive: true, force: true }));

/** What stands for the clone that is built: this tree, with the programs that are tested. */
function clone() {
  const to = join(repository, 'galilean');
  mkdirSync(join(to, 'build'), { recursive: true });
  for (const part of ['bhdl', 'docs', 'scripts']) symlinkSync(join(root, part), join(to, part));
  symlinkSync(dirname(galileanBinary), join(to, 'build/bin'));
}

const typed = (line) => spawnSync('bash', ['-e'], { cwd: repository, input: line, encoding: 'utf8', timeout: 60_000 });

/** The lines that are typed, but for those that fetch and build. */
const lines = () => page.split('## From an empty repository')[1].split('\n## ')[0].split('\n').filter((line) => line.startsWith('    ')).map((line) => line.trim())
  .filter((line) => !/^git clone|scripts\//.test(line));
/** The commands of the workflow's steps, folded lines as one. */
const steps = [...workflow.matchAll(/^ +(?:- )?run: (?:>\n((?: {10,}.*\n)+)|(.*)\n)/gm)].map(([, folded, line]) => (line ?? folded).trim().replace(/\s*\n\s*/g, ' '));

before(() => {
  clone();
  writeFileSync(join(repository, 'clean.expect'), /`clean\.expect`[^`]*```text\n([^`]+)```/.exec(page)[1]);
});

test('every line of the page can be typed, one after the other', () => {
  assert.ok(lines().length >= 8, lines().join('\n'));
  const { status, stdout, stderr } = typed(lines().join('\n'));
  assert.equal(status, 0, stdout + stderr);
  assert.match(stdout, /^programs\/clean\.bhdl: ok/m);
});

test('the workflow checks what the page has made, with options that there are', () => {
  const checks = steps.filter((step) => /galilean (bhdl|log) check/.test(step) && !step.includes('run.mcap'));
  assert.equal(checks.length, 2, steps.join('\n'));
  for (const step of checks) {
    const { status, stdout, stderr } = typed(step);
    assert.equal(status, 0, `${step}\n${stdout}${stderr}`);
  }
});

test('it runs and judges by options that there are', () => {
  const help = (verb) => typed(`galilean/build/bin/galilean ${verb} --help`).stdout;
  const runs = steps.filter((step) => /galilean (demo|log check run\.mcap)/.test(step));
  assert.equal(runs.length, 2, steps.join('\n'));
  for (const step of runs) {
    const told = help(/galilean (demo|log check)/.exec(step)[1]);
    for (const [option] of step.matchAll(/--[a-z-]+/g)) assert.ok(told.includes(option), `${step}: ${option}`);
  }
});

test('it builds by scripts that there are, and keeps what the page says', () => {
  const scripts = [...steps.join('\n').matchAll(/galilean\/scripts\/[a-z_]+\.sh/g)].map(([script]) => script);
  assert.equal(scripts.length, 2, steps.join('\n'));
  assert.deepEqual(scripts.filter((script) => !existsSync(join(repository, script))), []);
  assert.match(workflow, /\.galilean\n +include-hidden-files: true/);
});
