// SPDX-License-Identifier: BSD-3-Clause
// What the pages say of the tree is true of it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { withPicture } from '../../scripts/draw_rooms.mjs';

const root = new URL('../..', import.meta.url).pathname;
const pages = execFileSync(`${root}/scripts/sources.sh`, ['*.md']).toString().split('\n').filter(Boolean);

test('every link in a page leads somewhere', () => {
  const dead = pages.flatMap((page) => {
    const links = [...readFileSync(join(root, page), 'utf8').matchAll(/\]\(([^)\s#]+)(?:#[^)\s]*)?\)/g)].map((match) => match[1]);
    const missing = (link) => !/^[a-z]+:/.test(link) && !existsSync(join(root, dirname(page), link));
    return links.filter(missing).map((link) => `${page}: ${link}`);
  });
  assert.deepEqual(dead, []);
});

test('the picture of the rooms is the plan of the rooms', () => {
  const page = readFileSync(join(root, 'docs/ARCHITECTURE.md'), 'utf8');
  assert.equal(page, withPicture(page), 'draw it anew with: node scripts/draw_rooms.mjs --write');
});
