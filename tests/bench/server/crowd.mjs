// SPDX-License-Identifier: BSD-3-Clause
// 100 WebSocket clients that read all of a team's topics but its pictures: how late, and at what cost to the monitor.
//   node tests/bench/server/crowd.mjs [CLIENTS[:STALLED]=100] [ROBOTS=3] [SECONDS=10]
// Of the clients, STALLED stop reading at once, and the others are measured: 1000:100, for example.
import { createRequire } from 'node:module';
import { within } from '../../tools/patience.mjs';
import { bench, freePort, line, output, processorSeconds, program, root, scratchFolder, start } from './tools.mjs';

const require = createRequire(`${root}tests/node/`);
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const { WebSocket } = require('ws');
const [clients = '100'] = process.argv.slice(2);
const [robots = 3, seconds = 10] = process.argv.slice(3).map(Number);
const [count, stalled = '0'] = clients.split(':');
const costly = ['sensor_msgs/msg/CompressedImage', 'visualization_msgs/msg/MarkerArray'];

/** Ids of the channels, once each robot's are there. */
async function channels(port) {
  const socket = new WebSocket(`ws://127.0.0.1:${port}/ws`, ['foxglove.websocket.v1']);
  const client = new FoxgloveClient({ ws: socket });
  const found = new Map();
  await within(new Promise((resolve) => client.on('advertise', (list) => {
    for (const each of list) found.set(each.topic, each);
    if ([...found.keys()].filter((topic) => topic.endsWith('/sightings')).length === robots) setTimeout(resolve, 2000);
  })), () => `channels of ${robots} robots; there are ${[...found.keys()].join(' ')}`);
  socket.terminate();
  return [...found.values()].filter((each) => !costly.includes(each.schemaName)).map((each) => String(each.id));
}

await bench(async () => {
  const port = await freePort(), url = `http://127.0.0.1:${port}`;
  const demo = start(program('galilean'), ['demo', '--port', String(port), '--robots', String(robots)], { cwd: scratchFolder() });
  await line(demo, /http:\/\//);
  const ids = await channels(port);
  const began = [performance.now(), await processorSeconds(url)];
  const got = JSON.parse(output(program('crowd_bench'), [String(port), clients, String(seconds), ...ids]));
  const cores = (await processorSeconds(url) - began[1]) / ((performance.now() - began[0]) / 1000);
  console.log(`${count} clients, of whom ${stalled} stopped reading, ${robots} robots: ${(got.messages / seconds / 1000).toFixed(1)} k messages/s, late by ${got.median_ms} ms (median), `
    + `${got.p99_ms} ms (99 %), ${got.worst_ms} ms (worst); the monitor used ${cores.toFixed(2)} cores`);
});
