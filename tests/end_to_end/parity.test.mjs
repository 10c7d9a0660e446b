// SPDX-License-Identifier: BSD-3-Clause
// The table of docs/MONITOR.md: what an operator can do on the page, in the terminal, by command and over HTTP.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { description } from './openapi.mjs';
import { galilean, root } from './tools.mjs';

const textOf = (file) => readFileSync(`${root}${file}`, 'utf8');
const rows = textOf('docs/MONITOR.md').split('### What an operator can do, and where')[1].split('\n## ')[0].split('\n')
  .filter((line) => line.startsWith('| ') && !line.startsWith('| what')).map((line) => line.slice(2, -2).split(' | '));
const quoted = (cell) => [...cell.matchAll(/`([^`]+)`/g)].map(([, text]) => text);
const cells = (column) => rows.map((row) => [row[0], row[column]]);

test('the table has a cell for each of the four', () => {
  assert.ok(rows.length >= 15);
  for (const row of rows) assert.equal(row.length, 5, row[0]);
});

test('each command is there, with its options', () => {
  for (const [what, cell] of cells(3))
    for (const text of quoted(cell)) {
      const words = text.split(' ').slice(1);
      const { status, stdout } = galilean([...words.filter((word) => !word.startsWith('-')), '--help']);
      assert.equal(status, 0, `${what}: ${text}`);
      for (const option of words.filter((word) => word.startsWith('-'))) assert.ok(stdout.includes(`${option} `), `${what}: ${text}`);
    }
});

test('each request is described in openapi.yaml', () => {
  for (const [what, cell] of cells(4))
    for (const text of quoted(cell)) {
      const [method, path] = text.split(' ');
      assert.ok(description.paths[path]?.[method.toLowerCase()], `${what}: ${text}`);
    }
});

test('each key of the terminal is one that its help or a sheet names', () => {
  const help = [...textOf('monitor/top/panels/help.cpp').matchAll(/^ {6}"(\S.*?) {2,}/gm)].flatMap(([, keys]) => keys.split(/,? /));
  const sheets = [...textOf('monitor/top/sheets/push_sheet.cpp').matchAll(/"(\S+) cancel/g)].map(([, key]) => key);
  for (const [what, cell] of cells(2)) for (const key of quoted(cell)) assert.ok([...help, ...sheets].includes(key), `${what}: ${key}`);
});

test('each key and button of the page is there', () => {
  const sources = readdirSync(`${root}web/src`, { recursive: true }).filter((file) => /\.(svelte|ts)$/.test(file)).map((file) => textOf(`web/src/${file}`)).join('\n');
  const keys = [...sources.matchAll(/(?:onKey\(|^export const [A-Z_]+ = \[)"([^"]+)"/gm)].map(([, key]) => key);
  for (const [what, cell] of cells(1)) {
    for (const key of quoted(cell)) assert.ok(keys.includes(key === 'Space' ? ' ' : key), `${what}: ${key}`);
    const button = cell.replace(/`[^`]+`(, )?/g, '').trim();
    assert.ok(button === '' || button === '–' || new RegExp(`["'>]\\s*${button}\\b`).test(sources), `${what}: ${button}`);
  }
});
