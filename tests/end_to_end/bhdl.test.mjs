// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { closeSync, openSync, readFileSync, readdirSync, truncateSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { galilean, programs, scratchFolder } from './tools.mjs';

const minimal = `
output_devices: motor_drive: end
variables: shaft: name: "shaft" status: "valid"
  force: name: "ahead" value: <0, 1> status: "valid"
end
motor_schemas:
  move_robot: name: "move" input_force: "ahead" shaft_variable: "shaft" end
end
states: state: name: "go" motor_schemas: "move" end end
`;

function check(t, text, ...options) {
  const file = `${scratchFolder(t)}/program.bhdl`;
  writeFileSync(file, text);
  return galilean(['bhdl', 'check', file, ...options]);
}

test('every program that ships passes the check', () => {
  const mains = readdirSync(programs).filter((name) => name.endsWith('.bhdl') && !/^office_(robot|states)/.test(name));
  assert.ok(mains.length >= 4);
  const { status, stdout, stderr } = galilean(['bhdl', 'check', ...mains.map((name) => `${programs}/${name}`)]);
  assert.equal(status, 0, stdout + stderr);
});

test('a small program passes', (t) => assert.equal(check(t, minimal).status, 0));

test('errors have file, line, column and a hint, and all come in one run', (t) => {
  const { status, stdout, stderr } = check(t, minimal.replace('"ahead" shaft', '"ahaed" shaft').replace('"move" end', '"moev" end'));
  assert.equal(status, 1);
  const text = stdout + stderr;
  assert.match(text, /program\.bhdl:7:\d+: error: .*ahaed/);
  assert.match(text, /ahead/);
  assert.match(text, /program\.bhdl:9:\d+: error: .*moev/);
});

test('what cannot be seen is shown by its code, in names and as a stray character', (t) => {
  const stray = check(t, `${minimal}\u200b`);
  assert.match(stray.stderr, /error: the character 'U\+200B' has no meaning here/);
  const name = check(t, minimal.replace('motor_schemas: "move"', 'motor_schemas: "mo\u202Eve\u00A0"'));
  assert.match(name.stderr, /error: .*'moU\+202EveU\+00A0'/);
  assert.doesNotMatch(stray.stderr + name.stderr, /[\u200b\u202e\u00a0]/);
  const file = galilean(['bhdl', 'check', '/none\x1b[31m.bhdl']);
  assert.match(file.stderr, /^\/noneU\+001B\[31m\.bhdl/);
});

test('--json gives codes and positions', (t) => {
  const { status, stdout } = check(t, minimal.replace('input_force', 'input_forse'), '--json');
  assert.equal(status, 1);
  const answer = JSON.parse(stdout);
  const diagnostics = answer.diagnostics ?? answer.flatMap((each) => each.diagnostics);
  const unknown = diagnostics.find((each) => each.code === 'name/unknown-attribute');
  assert.equal(unknown.line, 7);
  assert.match(unknown.hint, /input_force/);
});

test('a file of 100 MB, and a binary one, are refused with one clear error', (t) => {
  const folder = scratchFolder(t);
  const large = `${folder}/large.bhdl`;
  closeSync(openSync(large, 'w'));
  truncateSync(large, 100e6);
  const tooLarge = galilean(['bhdl', 'check', large]);
  assert.equal(tooLarge.status, 1);
  assert.match(tooLarge.stdout + tooLarge.stderr, /large\.bhdl:1:1: error: /);

  const binary = galilean(['bhdl', 'check', process.execPath, '--json']);
  assert.equal(binary.status, 1);
  writeFileSync(`${folder}/binary.bhdl`, Buffer.from([0, 159, 146, 150, 0, 255]));
  const small = galilean(['bhdl', 'check', `${folder}/binary.bhdl`]);
  assert.equal(small.status, 1);
  assert.match(small.stdout + small.stderr, /binary\.bhdl:1:\d+: error: /);
});

test('a cycle of includes and a missing file are named', (t) => {
  const folder = scratchFolder(t);
  writeFileSync(`${folder}/a.bhdl`, 'include "b.bhdl"\n');
  writeFileSync(`${folder}/b.bhdl`, '; b\ninclude "a.bhdl"\n');
  const cycle = galilean(['bhdl', 'check', `${folder}/a.bhdl`]);
  assert.equal(cycle.status, 1);
  assert.match(cycle.stdout + cycle.stderr, /b\.bhdl:2:\d+: error: /);
  const missing = galilean(['bhdl', 'check', `${folder}/none.bhdl`]);
  assert.equal(missing.status, 1);
  assert.match(missing.stdout + missing.stderr, /none\.bhdl/);
});

test('describe prints the reference, and one component of it', () => {
  const all = galilean(['bhdl', 'describe']);
  assert.equal(all.status, 0);
  for (const name of ['move_to_goal', 'blob_detector', 'motor_drive', 'locate', 'condition']) assert.match(all.stdout, new RegExp(name));
  const one = galilean(['bhdl', 'describe', 'avoid_obstacle']);
  assert.match(one.stdout, /max_repulsion/);
  assert.notEqual(galilean(['bhdl', 'describe', 'avoid_obstacel']).status, 0);
});

test('fmt lays a file out, names it, changes nothing twice and leaves a broken one alone', (t) => {
  const file = `${scratchFolder(t)}/program.bhdl`;
  writeFileSync(file, 'state:\nname: “go” ; where it goes\nend:');
  assert.equal(galilean(['bhdl', 'fmt', '--check', file]).status, 1);
  const first = galilean(['bhdl', 'fmt', file]);
  assert.equal(first.status, 0, first.stderr);
  assert.equal(first.stdout, `${file}\n`);
  assert.equal(readFileSync(file, 'utf8'), 'state:\n  name: "go"  ; where it goes\nend\n');
  assert.deepEqual(galilean(['bhdl', 'fmt', file]), { status: 0, stdout: '', stderr: '' });
  assert.equal(galilean(['bhdl', 'fmt', '--check', file]).status, 0);

  const broken = 'state: name "go" end';
  writeFileSync(file, broken);
  const { status, stderr } = galilean(['bhdl', 'fmt', file]);
  assert.equal(status, 1);
  assert.match(stderr, /program\.bhdl:1:\d+: error: .*:/);
  assert.equal(readFileSync(file, 'utf8'), broken);
});

test('fmt - lays standard input out, and changes no program that ships', () => {
  const input = readFileSync(`${programs}/office_robot.bhdl`, 'utf8');
  const mine = input.replaceAll('\n  ', '\n'), windows = (text) => text.replaceAll('\n', '\r\n');
  assert.deepEqual(galilean(['bhdl', 'fmt', '-'], { input: mine }), { status: 0, stdout: input, stderr: '' });
  assert.deepEqual(galilean(['bhdl', 'fmt', '-'], { input: windows(mine) }), { status: 0, stdout: windows(input), stderr: '' });
  const shipped = readdirSync(programs).filter((name) => name.endsWith('.bhdl')).map((name) => `${programs}/${name}`);
  assert.deepEqual(galilean(['bhdl', 'fmt', '--check', ...shipped]), { status: 0, stdout: '', stderr: '' });
});

test('diff tells what one program does otherwise, in words and as JSON', (t) => {
  const folder = scratchFolder(t);
  writeFileSync(`${folder}/a.bhdl`, minimal);
  writeFileSync(`${folder}/b.bhdl`, minimal.replace('shaft_variable', 'safety_range: 45 shaft_variable'));
  const files = [`${folder}/a.bhdl`, `${folder}/b.bhdl`];
  const words = galilean(['bhdl', 'diff', ...files]);
  assert.equal(words.status, 1, words.stderr);
  assert.match(words.stdout, /^~ motor schema move_robot 'move': safety_range was \S+ deg, is 45 deg\n$/);
  const json = JSON.parse(galilean(['bhdl', 'diff', '--json', ...files]).stdout);
  assert.equal(json.same, false);
  assert.deepEqual([json.changes[0].attribute, json.changes[0].to, json.changes[0].unit], ['safety_range', 45, 'deg']);
  assert.deepEqual(galilean(['bhdl', 'diff', files[0], files[0]]), { status: 0, stdout: '', stderr: '' });
  assert.equal(galilean(['bhdl', 'diff', files[0], `${folder}/none.bhdl`]).status, 2);
  assert.equal(galilean(['bhdl', 'diff', files[0]]).status, 2);
});

test('graph draws the states as dot, SVG and JSON', () => {
  const graph = (format) => galilean(['bhdl', 'graph', '--format', format, `${programs}/office_cleanup.bhdl`]);
  assert.match(graph('dot').stdout, /"grab_trash" -> "backup1" \[label="gripper\[1\] is 1/);
  const { start_state: start, states } = JSON.parse(graph('json').stdout);
  assert.equal(start, 'start');
  const svg = graph('svg').stdout;
  assert.match(svg, /^<svg .*[^]*<\/svg>\n$/);
  for (const { name } of states) assert.ok(svg.includes(`>${name}</text>`), name);
  assert.notEqual(graph('png').status, 0);
});

test('programs that ship do what they expect of themselves', () => {
  const files = ['office_cleanup', 'sit_and_spin'].map((name) => `${programs}/${name}.bhdl`);
  const { status, stdout, stderr } = galilean(['bhdl', 'test', ...files]);
  assert.equal(status, 0, stdout + stderr);
  assert.match(stdout, /office_cleanup\.bhdl:\d+:1: passed: a push on any bumper begins the contest/);
  assert.match(stdout, /sit_and_spin\.bhdl:\d+:1: passed: /);
});

test('what a program does not do as expected is told with its line, and as JSON', (t) => {
  const file = `${scratchFolder(t)}/program.bhdl`;
  writeFileSync(file, `${minimal}expect:\n  name: "stops"\n  never: state: "go" end\nend\n`);
  const { status, stdout } = galilean(['bhdl', 'test', file]);
  assert.equal(status, 1);
  assert.match(stdout, /program\.bhdl:12:3: failed: stops: the state 'go' is current at 0 s/);
  const json = JSON.parse(galilean(['bhdl', 'test', file, '--json']).stdout);
  assert.equal(json.ok, false);
  assert.equal(json.programs[0].expectations[0].failures[0].line, 12);
});
