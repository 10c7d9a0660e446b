// SPDX-License-Identifier: BSD-3-Clause
// What a crowd subscribes to.
import { createRequire } from 'node:module';
import { within } from '../../tools/patience.mjs';
import { root } from './tools.mjs';

const require = createRequire(`${root}tests/node/`);
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const { WebSocket } = require('ws');
const costly = ['sensor_msgs/msg/CompressedImage', 'visualization_msgs/msg/MarkerArray'];

/** Ids of the channels but those of pictures and markers, once each robot's are there. */
export async function channels(port, robots) {
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
