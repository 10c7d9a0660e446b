// SPDX-License-Identifier: BSD-3-Clause
// Completion: what a shell is given, and what bash makes of it.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ownWords, places, verbs } from './help.mjs';
import { galilean, programs, root, scratchFolder } from './tools.mjs';

const script = Object.fromEntries(['bash', 'zsh', 'fish'].map((shell) => [shell, galilean(['completion', shell]).stdout]));
const everyPlace = places();

/** Calls _galilean with each list of words, of which the last is being typed; a blank line ends each answer. */
const driver = `
  source "$1"; shift
  COMP_WORDS=(galilean)
  for word; do
    [ "$word" != ';' ] && { COMP_WORDS+=("$word"); continue; }
    COMP_CWORD=$((\${#COMP_WORDS[@]} - 1))
    _galilean
    printf '%s\\n' "\${COMPREPLY[@]}" ---
    COMP_WORDS=(galilean)
  done`;

/** What bash offers for each line, in a folder, and with no program that it could start. */
function completeAll(t, lines, cwd = scratchFolder(t)) {
  const file = join(scratchFolder(t), 'galilean.bash');
  writeFileSync(file, script.bash);
  const words = lines.flatMap((line) => [...line.split(' '), ';']);
  const { status, stdout, stderr } = spawnSync('/bin/bash', ['--norc', '-c', driver, 'bash', file, ...words], { cwd, env: { PATH: '/none' }, encoding: 'utf8' });
  assert.deepEqual([status, stderr], [0, '']);
  return stdout.split('---\n').slice(0, -1).map((answer) => answer.split('\n').filter(Boolean).sort());
}
const complete = (t, line, cwd) => completeAll(t, [line], cwd)[0];

/** Checks the script by the shell itself, where that is installed. */
function checkSyntax(t, shell) {
  const file = join(scratchFolder(t), shell);
  writeFileSync(file, script[shell]);
  const { error, status, stderr } = spawnSync(shell, ['-n', file], { encoding: 'utf8' });
  if (error?.code !== 'ENOENT' || shell === 'bash') assert.deepEqual([status, stderr], [0, '']);
}

test('bash reads its script', (t) => checkSyntax(t, 'bash'));

test('bash completes verbs, and commands in them', (t) => {
  const first = [...new Set(verbs().map(([word]) => word)), ...ownWords].sort();
  assert.deepEqual(complete(t, ''), first);
  assert.deepEqual(complete(t, 'mon'), ['monitor']);
  assert.deepEqual(complete(t, 'bhdl d'), ['describe', 'diff']);
  assert.deepEqual(complete(t, 'sim ct'), ['ctl']);
  assert.deepEqual(complete(t, 'sim ctl p'), ['pause', 'push']);
});

test('bash offers every command and option that --help has', (t) => {
  const commands = completeAll(t, everyPlace.map(({ path }) => `${path.join(' ')} `));
  const options = completeAll(t, everyPlace.map(({ path }) => `${path.join(' ')} -`));
  everyPlace.forEach((place, at) => {
    for (const command of place.commands) assert.ok(commands[at].includes(command), `${place.path.join(' ')} ${command}`);
    for (const option of place.options) assert.ok(options[at].includes(option), `${place.path.join(' ')} ${option}`);
  });
  assert.ok(everyPlace.length > 40 && everyPlace.some(({ options: some }) => some.includes('--scenario')));
});

test('bash completes options, and those of an outer command', (t) => {
  assert.deepEqual(complete(t, 'sim --scen'), ['--scenario']);
  assert.deepEqual(complete(t, 'programs list --mon'), ['--monitor']);
  assert.deepEqual(complete(t, 'programs --monitor http : //127.0.0.1 : 8080 list --js'), ['--json']);
  assert.deepEqual(complete(t, 'bhdl check --form'), []);
});

test('bash completes values: choices, what ships, and what an argument may be', (t) => {
  assert.deepEqual(complete(t, 'bhdl graph --format s'), ['svg']);
  const shipped = (folder, extension) => readdirSync(folder).filter((name) => name.endsWith(extension)).map((name) => name.slice(0, -extension.length)).sort();
  assert.deepEqual(complete(t, 'sim --scenario '), shipped(`${root}sim/scenarios`, '.json'));
  assert.deepEqual(complete(t, 'demo --bhdl '), shipped(programs, '.bhdl'));
  assert.deepEqual(complete(t, 'sim --scenario = off'), ['office']);
  assert.deepEqual(complete(t, 'sim --scenario ='), complete(t, 'sim --scenario '));
  assert.deepEqual(complete(t, 'sim ctl drop c'), ['can', 'cup']);
  assert.deepEqual(complete(t, 'sim ctl break io bumper_7'), ['bumper_7']);
  assert.deepEqual(complete(t, 'sim ctl break bumper_7'), []);
  assert.deepEqual(complete(t, 'sim ctl drop can -1 c'), []);
  assert.deepEqual(complete(t, 'completion f'), ['fish']);
  assert.deepEqual(complete(t, 'manual pro'), ['programs']);
  assert.deepEqual(complete(t, 'manual sim c'), ['check', 'ctl']);
});

test('bash completes files of the kind that is wanted, and folders', (t) => {
  const cwd = scratchFolder(t);
  for (const name of ['mine.bhdl', 'run.mcap', 'my notes.txt']) writeFileSync(join(cwd, name), '');
  mkdirSync(join(cwd, 'more'));
  assert.deepEqual(complete(t, 'bhdl check ', cwd), ['mine.bhdl', 'more']);
  assert.deepEqual(complete(t, 'bhdl check mine.bhdl mi', cwd), ['mine.bhdl']);
  assert.deepEqual(complete(t, 'bhdl check --json mi', cwd), ['mine.bhdl']);
  assert.deepEqual(complete(t, 'swap --author check mi', cwd), ['mine.bhdl']);
  assert.deepEqual(complete(t, 'bhdl graph mine.bhdl mi', cwd), []);
  assert.deepEqual(complete(t, 'replay r', cwd), ['run.mcap']);
  assert.deepEqual(complete(t, 'monitor --web ', cwd), ['more']);
  assert.deepEqual(complete(t, 'robot --serial my', cwd), ['my notes.txt']);
  assert.deepEqual(complete(t, 'robot --bhdl no', cwd), []);
});

test('zsh gets every command and option that --help has', (t) => {
  checkSyntax(t, 'zsh');
  assert.match(script.zsh, /^#compdef galilean\n/);
  for (const { path, options, commands } of everyPlace) {
    const name = `_galilean_at_${path.join('_').replaceAll('-', '_')}`;
    const body = script.zsh.split(`\n${name}() {\n`)[1]?.split('\n}\n')[0];
    assert.ok(body, name);
    for (const option of options) assert.match(body, new RegExp(`^ {4}'(\\*|\\([^)]*\\))${option}=?\\[`, 'm'), `${name} ${option}`);
    for (const command of commands) assert.match(body, new RegExp(`^ {4}'${command}:`, 'm'), `${name} ${command}`);
  }
});

test('fish gets every command and option that --help has', (t) => {
  checkSyntax(t, 'fish');
  for (const { path, options, commands } of everyPlace) {
    const rules = script.fish.split('\n').filter((line) => line.startsWith(`complete -c galilean -n "__galilean_at '${path.join(' ')}'"`));
    const has = (pattern) => assert.ok(rules.some((rule) => pattern.test(rule)), `${path.join(' ')} ${pattern}`);
    for (const option of options) has(option.startsWith('--') ? new RegExp(` -l ${option.slice(2)} `) : new RegExp(` -s ${option.slice(1)} `));
    for (const command of commands) has(new RegExp(` -a ${command} `));
  }
});

test('zsh and fish get values too: choices, what ships, files and folders', () => {
  assert.match(script.zsh, /--format=\[[^\n]*:\(dot svg json\)' /);
  assert.match(script.zsh, /--scenario=\[[^\n]*"[^"]*\boffice\b[^"]*" "\*\.json"' /);
  assert.match(script.zsh, /--web=\[[^\n]*:_files -\/' /);
  assert.match(script.zsh, /'\*:FILE:_files -g "\*\.bhdl"' /);
  const rule = (place, name) => script.fish.split('\n').find((line) => line.includes(`"__galilean_at '${place}'"`) && line.includes(name));
  assert.match(rule('bhdl graph', '-l format'), / -r -a 'dot svg json' -f /);
  assert.match(rule('sim', '-l scenario'), / -r -a '[^']*\boffice\b[^']*\(__galilean_files \.json\)' -f /);
  assert.match(rule('monitor', '-l web'), / -r -a '\(__fish_complete_directories\)' -f /);
  assert.match(rule('bhdl check', '-a \'(__galilean_files .bhdl)\''), / -d 'programs'$/);
  assert.match(rule('robot', '-l serial'), / -r -F /);
});

test('a shell that is not known is refused', () => {
  const { status, stderr } = galilean(['completion', 'csh']);
  assert.equal(status, 2);
  assert.match(stderr, /csh/);
});
