// SPDX-License-Identifier: BSD-3-Clause
// What one component is to others is told by its declaration, and not by its name: docs/ADD_A_SCHEMA.md.
// What many files would do anew, one file does for them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const root = new URL('../..', import.meta.url).pathname;
const LIST = 'robot/components.cpp';
const SCHEMAS = ['robot/perceptual/', 'robot/motor/'];
const textOf = (file) => readFileSync(`${root}/${file}`, 'utf8');
const files = execFileSync(`${root}/scripts/sources.sh`, ['*.h', '*.cpp', '*.ts', '*.svelte', '*.mjs']).toString().split('\n')
  .filter((file) => /^(core|bhdl|robot|monitor|sim|web\/src)\//.test(file) && file !== LIST);
const named = (kind) => [...textOf(LIST).matchAll(new RegExp(`add_${kind}<\\w+>\\("(\\w+)"`, 'g'))].map((match) => match[1]);
const [schemas, others] = [named('schema'), named('settings')];

/** Where the words for devices and for types of variables stand, once for C++ and once for the page. */
const VOCABULARY = ['core/device/device_names.h', 'core/variable/type_name.h', 'web/src/model/variable_text.ts'];
/** The same word for something else. */
const OTHER_MEANINGS = {
  lost: ['web/src/feed/feed.ts', 'web/src/feed/feed_server.ts', 'web/src/model/live.svelte.ts', 'web/src/shell/Announcer.svelte', 'web/src/shell/Header.svelte', 'monitor/record/log_info_json.cpp'], // a connection; messages
  dock: ['web/src/shell/Dock.svelte'], // of panels
  noise: ['sim/camera/renderer.cpp'], // of a camera's pixels
  bits: ['web/src/plots/quantities.ts'], // what is plotted
  shaft: ['robot/perceptual/arrived.cpp', 'robot/perceptual/obstacle_detector.cpp', 'robot/perceptual/seen.cpp'], // a variable's name
};

const withoutComments = (text) => text.replace(/\/\*[\s\S]*?\*\//g, '').replace(/(^|[^:"'])\/\/.*$/gm, '$1');
const isOwn = (file, name) => SCHEMAS.some((folder) => [`${folder}${name}.h`, `${folder}${name}.cpp`].includes(file));

/** Of one file: the names that it may not have, each in quotes; in a comment, too, where it could be no other word. */
function offences(file, text) {
  const code = withoutComments(text);
  const inQuotes = (name) => new RegExp(`(["'\`])${name}\\1`).test(code);
  const anywhere = (name) => name.includes('_') && !SCHEMAS.some((folder) => file.startsWith(folder)) && new RegExp(`\\b${name}\\b`).test(text);
  const isAllowed = (name) => isOwn(file, name) || OTHER_MEANINGS[name]?.includes(file);
  return [
    ...schemas.filter((name) => !isAllowed(name) && (inQuotes(name) || anywhere(name))),
    ...others.filter((name) => !isAllowed(name) && !VOCABULARY.includes(file) && inQuotes(name)),
  ];
}

test('the list of components is read', () => {
  assert.ok(schemas.length >= 20 && others.length >= 9, `${schemas} ${others}`);
});

test('no file but its own and the list names a component', () => {
  assert.deepEqual(files.flatMap((file) => offences(file, textOf(file)).map((name) => `${file} names ${name}`)), []);
});

test('a name is found in quotes, and in a comment where it can be nothing else', () => {
  const [schema] = schemas.filter((name) => name.includes('_'));
  assert.deepEqual(offences('monitor/a.cpp', `if (type == "${schema}") {}`), [schema]);
  assert.deepEqual(offences('monitor/a.cpp', `// of ${schema}`), [schema]);
  assert.deepEqual(offences('web/src/a.ts', `const type = 'lost'; // "seen"`), ['lost']);
  assert.deepEqual(offences('monitor/a.cpp', 'devices.motor_drive.stop(); // "motor_drive"'), []);
});

test('what has another meaning is still there', () => {
  const gone = Object.entries(OTHER_MEANINGS).flatMap(([name, places]) => places.filter((file) => !files.includes(file) || !new RegExp(`(["'\`])${name}\\1`).test(textOf(file))));
  assert.deepEqual(gone, []);
});

test('JSON becomes text in one place, which no text from outside makes throw', () => {
  const PLACES = ['core/json_text.cpp', 'sim/scenario/json_reader.cpp']; // the other prints a value within an error, in ASCII
  const calls = /\.dump\(|json::parse\(/;
  assert.deepEqual(files.filter((file) => file.endsWith('.cpp') && !PLACES.includes(file) && calls.test(withoutComments(textOf(file)))), []);
});
