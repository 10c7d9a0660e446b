// SPDX-License-Identifier: BSD-3-Clause
// A monitor with a crowd of viewers of whom some stop reading, with programs that are checked and with floods of requests,
// and how long an operator's commands take beside that. The crowd has what processor time others leave, so that what is
// measured is the monitor.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { request } from 'node:http';
import { setTimeout as sleep } from 'node:timers/promises';
import { eventually, within } from './patience.mjs';

const LOAD = new URL('load_process.mjs', import.meta.url).pathname;
/** The crowd is ended when all was measured. */
const LONG_S = 600;

const modest = (command, args, options) => spawn('nice', ['-n', '19', command, ...args], options);

async function viewersOf(url) {
  const text = await (await fetch(`${url}/metrics`)).text();
  return Number(/^galilean_websocket_clients (\d+)/m.exec(text)?.[1]);
}

/**
 * Lets `measure()` run while the monitor at `port` has so many viewers of the channels `ids`, of whom `stalled` do not read,
 * and so many checks and floods. Returns what it returns.
 */
export async function crowded({ port, ids, crowdBench, viewers, stalled, checks, floods }, measure) {
  const url = `http://127.0.0.1:${port}`;
  const crowd = modest(crowdBench, [String(port), `${viewers}:${stalled}`, String(LONG_S), ...ids], { stdio: ['ignore', 'ignore', 'pipe'] });
  const load = modest(process.execPath, [LOAD, url, String(checks), String(floods)], { stdio: ['pipe', 'pipe', 'inherit'] });
  const ends = [crowd, load].map((child) => once(child, 'close'));
  let problem = '';
  crowd.stderr.on('data', (data) => { problem += data; });
  try {
    await within(once(load.stdout, 'data'), () => 'the load to begin');
    await eventually(async () => {
      if (crowd.exitCode !== null) throw new Error(`no crowd came: ${problem}`);
      await sleep(100);
      return await viewersOf(url) >= viewers;
    });
    return await measure();
  } finally {
    load.stdin.end();
    crowd.kill();
    await within(Promise.all(ends), () => 'the end of the crowd');
  }
}

/** How long the monitor takes to answer a hold, on a connection of its own [ms]. */
function commandTime(url, token) {
  const began_ms = performance.now();
  return within(new Promise((resolve, reject) => {
    const asked = request(`${url}/api/command`, { agent: false, method: 'POST', headers: { authorization: `Bearer ${token}` } }, (answer) => {
      answer.resume().on('end', () => {
        if (answer.statusCode === 200) resolve(performance.now() - began_ms);
        else reject(new Error(`a hold is answered with ${answer.statusCode}`));
      });
    });
    asked.on('error', reject).end(JSON.stringify({ kind: 'hold' }));
  }), () => 'the answer to a hold');
}

/** How long so many holds took, one after another, in order of size [ms]. */
export async function commandTimes(url, token, count) {
  const taken = [];
  for (let i = 0; i < count; ++i) taken.push(await commandTime(url, token));
  return taken.sort((one, other) => one - other);
}

/** The value below which 99 of 100 are. Requires: `sorted` is. */
export const p99 = (sorted) => sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * 0.99))];
