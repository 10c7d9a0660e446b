// SPDX-License-Identifier: BSD-3-Clause
// What the tests of scripts share.
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const root = new URL('../..', import.meta.url).pathname;

/** Runs a command to its end, with what it said as text. */
export const run = (command, args, options) => spawnSync(command, args, { encoding: 'utf8', timeout: 60_000, ...options });

/** A folder with these files, each a program too, by their paths in it. */
export function folderWith(t, files) {
  const folder = mkdtempSync(join(tmpdir(), 'galilean-scripts-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(join(folder, path, '..'), { recursive: true });
    writeFileSync(join(folder, path), text, { mode: 0o755 });
  }
  return folder;
}
