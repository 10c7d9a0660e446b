// SPDX-License-Identifier: BSD-3-Clause
// The folders are the architecture: who may include whom.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { circle, offence, roomOf, rooms } from './rooms.mjs';

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

test('only core/wire and its tests include Cyclone', () => {
  assert.deepEqual(offences((file, name) => /^dds\//.test(name) && !/^(tests\/)?core\/wire\//.test(file)), []);
});

// Reader::take hands over what is within its bounds. Topics that are read as bytes have none: what is made of those must
// not be trusted, so that whoever reads such a topic stands here.
test('messages pass by their bounds only where bytes are shown or kept as they came', () => {
  const passesBy = /\btake_unchecked\b|\bUntypedTopic\b/;
  const may = /^(core\/wire|tests\/core\/wire|tests\/monitor\/wire)\/|^monitor\/(record\/topic_recording|wire\/topic_reader)\./;
  assert.deepEqual(sources.filter((file) => passesBy.test(readFileSync(`${root}/${file}`, 'utf8')) && !may.test(file)), []);
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

test('no line of a build file is over 110 columns', () => {
  const long = (file) => readFileSync(`${root}/${file}`, 'utf8').split('\n').filter((line) => line.length > 110);
  assert.deepEqual(filesNamed('CMakeLists.txt', '*.cmake').flatMap((file) => long(file).map((line) => `${file}: ${line}`)), []);
});

const pageSources = filesNamed('*.ts', '*.svelte').filter((file) => file.startsWith('web/src/'));

function imports(file) {
  const text = readFileSync(`${root}/${file}`, 'utf8');
  const found = [...text.matchAll(/(?:from|import)\s*\(?\s*["'](\.{1,2}\/[^"']*)["']/g)].map((match) => match[1]);
  return found.map((name) => join(dirname(file), name));
}

const arrows = [
  ...sources.flatMap((file) => includes(file).map((name) => [file, name])),
  ...pageSources.flatMap((file) => imports(file).map((name) => [file, name])),
];

test('every folder is a room that the plan knows, and every room of the plan is there', () => {
  const there = new Set([...sources, ...pageSources].map(roomOf).filter(Boolean).map(({ top, room }) => `${top}/${room}`));
  const known = new Set(Object.entries(rooms).flatMap(([top, inside]) => Object.keys(inside).map((room) => `${top}/${room}`)));
  assert.deepEqual([...there].filter((room) => !known.has(room)), [], 'rooms that rooms.mjs does not know');
  assert.deepEqual([...known].filter((room) => !there.has(room)), [], 'rooms that are gone');
});

test('rooms include only the rooms that the plan allows', () => {
  const offending = arrows.map(([file, name]) => [offence(roomOf(file), roomOf(name)), file, name]).filter(([why]) => why);
  assert.deepEqual(offending.map(([why, file, name]) => `${file} includes ${name}: ${why}`), []);
});

test('no way through the plan leads in a circle', () => {
  for (const top of Object.keys(rooms)) assert.equal(circle(top)?.join(' -> '), undefined);
});

test('what the plan does not allow is an offence', () => {
  assert.match(offence(roomOf('bhdl/syntax/parser.cpp'), roomOf('bhdl/lint/idle_check.h')), /may not include/);
  assert.match(offence(roomOf('bhdl/attic/x.cpp'), roomOf('bhdl/lint/idle_check.h')), /does not know/);
  assert.equal(offence(roomOf('bhdl/lint/idle_check.cpp'), roomOf('bhdl/syntax/parser.h')), undefined);
});

test('tests stand in rooms that are there', () => {
  const known = new Set(Object.entries(rooms).flatMap(([top, inside]) => Object.keys(inside).map((room) => `${top}/${room}`)));
  const ofTests = sources.filter((file) => file.startsWith('tests/')).map((file) => dirname(file).slice('tests/'.length));
  const mirrored = ofTests.filter((place) => place.split('/')[0] in rooms && place.includes('/'));
  const extra = ['monitor/map/truth', 'bhdl/editors'];
  assert.deepEqual([...new Set(mirrored)].filter((place) => !known.has(place) && !extra.includes(place)), []);
});
