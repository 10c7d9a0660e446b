// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { test } from 'node:test';
import { freshDomain } from './domain.mjs';
import { within } from './patience.mjs';

const here = new URL('.', import.meta.url).href;

/** The domain of a process that begins to look where every other of these does, and that lives on. */
async function domainOfAnother(t) {
  const text = `Object.defineProperty(process, 'pid', { value: 7 });
    console.log((await import('${here}domain.mjs')).freshDomain());
    process.stdin.resume();`;
  const child = spawn(process.execPath, ['--input-type=module', '-e', text], { stdio: ['pipe', 'pipe', 'inherit'] });
  t.after(() => child.stdin.end());
  return Number(String((await within(once(child.stdout, 'data'), () => 'a domain'))[0]));
}

test('processes that live at a time have a DDS domain each', async (t) => {
  const domains = await Promise.all(Array.from({ length: 5 }, () => domainOfAnother(t)));
  assert.equal(new Set(domains).size, 5, domains.join(' '));
  for (const domain of domains) assert.ok(domain >= 20 && domain < 100, `${domain}`);
});

test('one process has as many as it asks for, and never the one that it is run in', () => {
  const domains = Array.from({ length: 8 }, freshDomain);
  assert.equal(new Set(domains).size, 8);
  assert.ok(!domains.includes(process.env.ROS_DOMAIN_ID));
});

test('a command is run in a domain of its own, and its exit code is given on', () => {
  const text = 'echo $ROS_DOMAIN_ID $GALILEAN_TEST_DOMAIN; exit 3';
  const { status, stdout } = spawnSync(process.execPath, [new URL('with_domain.mjs', here).pathname, 'sh', '-c', text], { encoding: 'utf8' });
  assert.equal(status, 3);
  assert.match(stdout, /^(\d+) \1\n$/);
});
