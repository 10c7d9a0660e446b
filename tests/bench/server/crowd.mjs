// SPDX-License-Identifier: BSD-3-Clause
// 100 WebSocket clients that read all of a team's topics but its pictures: how late, and at what cost to the monitor.
//   node tests/bench/server/crowd.mjs [CLIENTS[:STALLED]=100] [ROBOTS=3] [SECONDS=10]
// Of the clients, STALLED stop reading at once, and the others are measured: 1000:100, for example.
import { channels } from './channels.mjs';
import { bench, freePort, line, output, processorSeconds, program, scratchFolder, start } from './tools.mjs';

/** What is wanted where some stop reading. */
const LIMIT_MS = 100;
const [clients = '100'] = process.argv.slice(2);
const [robots = 3, seconds = 10] = process.argv.slice(3).map(Number);
const [count, stalled = '0'] = clients.split(':');

await bench(async () => {
  const port = await freePort(), url = `http://127.0.0.1:${port}`;
  const demo = start(program('galilean'), ['demo', '--port', String(port), '--robots', String(robots)], { cwd: scratchFolder() });
  await line(demo, /http:\/\//);
  const ids = await channels(port, robots);
  const began = [performance.now(), await processorSeconds(url)];
  const got = JSON.parse(output(program('crowd_bench'), [String(port), clients, String(seconds), ...ids]));
  const cores = (await processorSeconds(url) - began[1]) / ((performance.now() - began[0]) / 1000);
  console.log(`${count} clients, of whom ${stalled} stopped reading, ${robots} robots: ${(got.messages / seconds / 1000).toFixed(1)} k messages/s, late by ${got.median_ms} ms (median), `
    + `${got.p99_ms} ms (99 %, ${(got.p99_ms / LIMIT_MS).toFixed(2)} × the limit of ${LIMIT_MS} ms), ${got.worst_ms} ms (worst); the monitor used ${cores.toFixed(2)} cores`);
});
