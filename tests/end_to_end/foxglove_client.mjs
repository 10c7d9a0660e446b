// SPDX-License-Identifier: BSD-3-Clause
// A client of the monitor's WebSocket: the one that Foxglove's protocol's authors wrote.
import { createRequire } from 'node:module';
import { within } from '../tools/patience.mjs';
import { root } from './tools.mjs';

const require = createRequire(`${root}tests/node/`);
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const { WebSocket } = require('ws');
const { parseRos2idl } = require('@foxglove/ros2idl-parser');
const { MessageReader } = require('@foxglove/rosmsg2-serialization');

/** A client, with `next(event, suits)`: the first that came, or will come, and suits. */
export function connect(t, url, { token = '', protocol = 'foxglove.websocket.v1' } = {}) {
  const socket = new WebSocket(`${url.replace('http', 'ws')}/ws${token && `?token=${token}`}`, [protocol]);
  const client = new FoxgloveClient({ ws: socket });
  t.after(() => socket.terminate());
  const heard = {}, waiting = new Set();
  for (const event of ['serverInfo', 'status', 'advertise', 'advertiseServices', 'message', 'time', 'parameterValues',
    'connectionGraphUpdate', 'serviceCallResponse', 'serviceCallFailure', 'error'])
    client.on(event, (what) => {
      (heard[event] ??= []).push(what);
      for (const look of waiting) look();
    });
  const next = (event, suits = () => true) => within(new Promise((resolve) => {
    const look = () => {
      const found = (heard[event] ?? []).find(suits);
      if (found === undefined) return;
      waiting.delete(look);
      resolve(found);
    };
    waiting.add(look);
    look();
  }), () => `'${event}' with ${suits}; heard were ${Object.keys(heard)}`);
  const channel = async (topic) => (await next('advertise', (list) => list.some((each) => each.topic === topic))).find((each) => each.topic === topic);
  const service = async (name) => (await next('advertiseServices')).find((each) => each.name === name);
  return { client, socket, heard, next, channel, service };
}

/** Decodes a channel's messages by the schema that the channel itself carries. */
export function readerOf(channel) {
  const all = parseRos2idl(channel.schema);
  const own = all.find((definition) => definition.name === channel.schemaName);
  return new MessageReader([{ ...own, name: undefined }, ...all.filter((definition) => definition !== own)]);
}
