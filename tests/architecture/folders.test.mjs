// The folders are the architecture: who may include whom.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const root = new URL('../..', import.meta.url).pathname;
const filesNamed = (...patterns) =>
  execFileSync(`${root}/scripts/sources.sh`, patterns).toString().split('\n').filter(Boolean);
const sources = filesNamed('*.h', '*.cpp');

const mayInclude = {
  core: ['core'],
  bhdl: ['core', 'bhdl'],
  robot: ['core', 'bhdl', 'robot'],
  sim: ['core', 'bhdl', 'robot', 'sim'],
  monitor: ['core', 'bhdl', 'monitor'],
};

function includes(file) {
  const text = readFileSync(`${root}/${file}`, 'utf8');
  return [...text.matchAll(/^\s*#\s*include\s+[<"]([^>"]+)[>"]/gm)].map((match) => match[1]);
}

function offences(isOffence) {
  return sources.flatMap((file) => includes(file).filter((name) => isOffence(file, name)).map((name) => `${file} includes ${name}`));
}

const folder = (path) => path.split('/')[0];

test('folders include only what lies to their left', () => {
  assert.deepEqual(offences((file, name) =>
    folder(file) in mayInclude && folder(name) in mayInclude && !mayInclude[folder(file)].includes(folder(name))), []);
});

test('only core/wire includes Cyclone', () => {
  assert.deepEqual(offences((file, name) => /^dds\//.test(name) && !file.startsWith('core/wire/')), []);
});

test('MRPT stays in .cpp files of monitor/map and of its tests', () => {
  assert.deepEqual(offences((file, name) =>
    /^mrpt\//.test(name) && !/^(tests\/)?monitor\/map\/.*\.cpp$/.test(file)), []);
});

test('perceptual and motor schemas know neither one another, nor the executive, nor the wire', () => {
  const forbidden = { 'robot/perceptual/': /^(robot\/(motor|executive|telemetry)|core\/wire)\//, 'robot/motor/': /^(robot\/(perceptual|executive|telemetry)|core\/wire)\// };
  assert.deepEqual(offences((file, name) =>
    Object.entries(forbidden).some(([place, what]) => file.startsWith(place) && what.test(name))), []);
});

test('build files list their sources', () => {
  const files = filesNamed('CMakeLists.txt', '*.cmake');
  assert.deepEqual(files.filter((file) => /file\s*\(\s*GLOB/i.test(readFileSync(`${root}/${file}`, 'utf8'))), []);
});
