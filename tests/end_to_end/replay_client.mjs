// SPDX-License-Identifier: BSD-3-Clause
// A viewer of a recording: Foxglove's protocol with playback control, byte by byte.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { createRequire } from 'node:module';
import { within } from '../tools/patience.mjs';
import { START_NS } from './small_recording.mjs';
import { root } from './tools.mjs';

const { WebSocket } = createRequire(`${root}tests/node/`)('ws');
const STATUS = ['playing', 'paused', 'buffering', 'ended'];
const seconds = (ns) => Number((ns - START_NS) / 1000n) / 1e6;

class Viewer {
  texts = [];
  states = [];
  messages = [];
  clock_s = undefined;
  #waiting = new Set();
  #asked = 0;

  constructor(socket) {
    this.socket = socket;
    this.closed = within(once(socket, 'close').then(([code, reason]) => ({ code, reason: reason.toString() })), () => 'the end of a replay');
    this.closed.catch(() => {});
    socket.on('message', (data, isBinary) => {
      if (isBinary) this.#binary(data);
      else this.texts.push(JSON.parse(data));
      for (const look of this.#waiting) look();
    });
    this.first = this.#found(() => this.texts[0], () => 'the first message');
    this.first.catch(() => {});
  }

  #binary(data) {
    if (data[0] === 1) this.messages.push({ subscription: data.readUInt32LE(1), at_s: seconds(data.readBigUInt64LE(5)), data: data.subarray(13) });
    if (data[0] === 2) this.clock_s = seconds(data.readBigUInt64LE(1));
    if (data[0] === 5)
      this.states.push({
        status: STATUS[data[1]], now_s: seconds(data.readBigUInt64LE(2)), speed: data.readFloatLE(10),
        did_seek: data[14] === 1, id: data.subarray(19, 19 + data.readUInt32LE(15)).toString(), messagesBefore: this.messages.length,
      });
  }

  #found(look, what) {
    return within(new Promise((resolve) => {
      const again = () => {
        const found = look();
        if (found === undefined) return;
        this.#waiting.delete(again);
        resolve(found);
      };
      this.#waiting.add(again);
      again();
    }), () => `${what()}; heard were ${JSON.stringify([this.texts.map(({ op, message }) => message ?? op), this.states])}`);
  }

  /** The first message of that kind. */
  text(op) {
    return this.#found(() => this.texts.find((each) => each.op === op), () => op);
  }

  /** The answer to that request. */
  state(id) {
    return this.#found(() => this.states.find((each) => each.id === id), () => `a state for ${id}`);
  }

  /** The newest state, as soon as it is such. */
  until(suits) {
    return this.#found(() => { const newest = this.states.at(-1); return newest && suits(newest) ? newest : undefined; }, () => `a state with ${suits}`);
  }

  /** Subscribes to channels, each under its own number. */
  async subscribe(channels) {
    this.socket.send(JSON.stringify({ op: 'subscribe', subscriptions: channels.map((id) => ({ id, channelId: id })) }));
  }

  control({ pause = false, speed = 1, seek_s, id }) {
    const request = Buffer.alloc(19 + id.length);
    request[0] = 3;
    request[1] = pause ? 1 : 0;
    request.writeFloatLE(speed, 2);
    request[6] = seek_s === undefined ? 0 : 1;
    request.writeBigUInt64LE(seek_s === undefined ? 0n : START_NS + BigInt(Math.round(seek_s * 1e9)), 7);
    request.writeUInt32LE(id.length, 15);
    request.write(id, 19);
    this.socket.send(request);
  }

  /** Goes there, and forgets what came before. */
  async seek(seek_s, { pause }) {
    const id = `seek ${++this.#asked}`;
    this.control({ pause, seek_s, id });
    const state = await this.state(id);
    this.messages = this.messages.slice(state.messagesBefore);
    return state;
  }

  /** What has come when the server has done all that it was asked for: it answers in order. */
  async settled() {
    const id = `settled ${++this.#asked}`;
    this.control({ pause: true, id });
    await this.state(id);
    return this.messages;
  }

  forget() {
    this.messages = [];
  }

  leave() {
    this.socket.terminate();
  }
}

export async function replay(t, url, name, more = '') {
  const socket = new WebSocket(`${url.replace('http', 'ws')}/replay?recording=${name}${more}`, ['foxglove.sdk.v1']);
  t.after(() => socket.terminate());
  const viewer = new Viewer(socket);
  await within(once(socket, 'open'), () => `a replay of ${name}`);
  assert.equal(socket.protocol, 'foxglove.sdk.v1');
  return viewer;
}
