// SPDX-License-Identifier: BSD-3-Clause
// An installed tree works where it was put: programs find what they read beside them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root, scratchFolder } from './tools.mjs';

const build = process.env.GALILEAN_BUILD ?? `${root}build`;

test('cmake --install into a DESTDIR gives programs that find their share folder', { timeout: 120_000 }, (t) => {
  const destination = scratchFolder(t);
  execFileSync('cmake', ['--install', build, '--prefix', '/usr'], { env: { ...process.env, DESTDIR: destination } });
  const galilean = (...words) =>
    execFileSync(join(destination, 'usr/bin/galilean'), words, { cwd: destination, encoding: 'utf8' });

  const shipped = (name) => existsSync(join(destination, 'usr/share/galilean', name));
  for (const name of ['catalog.json', 'web/index.html', 'programs/office_cleanup.bhdl', 'scenarios/office.json'])
    assert.ok(shipped(name), name);
  for (const module of ['libgalilean_opencv_source.so', 'libgalilean_png.so', 'libgalilean_authentication.so'])
    assert.ok(existsSync(join(destination, 'usr/lib/galilean', module)), module);

  const below = (name) => existsSync(join(destination, 'usr/share', name));
  for (const name of ['man/man1/galilean.1', 'man/man1/galilean-sim-ctl.1', 'bash-completion/completions/galilean',
    'zsh/site-functions/_galilean', 'fish/vendor_completions.d/galilean.fish'])
    assert.ok(below(name), name);

  assert.match(galilean('bhdl', 'describe', 'move_to_goal'), /move_to_goal/);
  const run = JSON.parse(galilean('sim', '--headless', '--scenario', 'office', '--robots', '3', '--seed', '1', '--duration', '5', '--json'));
  assert.ok(run.hash);
});
