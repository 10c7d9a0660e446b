// SPDX-License-Identifier: BSD-3-Clause
// One minute of a headless contest, recorded, judged by expectations, and read back by MCAP's reference reader.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, describe, test } from 'node:test';
import { McapIndexedReader, MessageReader, definitionsOf, unzstd } from '../logs/tools.mjs';
import { freePort, freshDomain, galilean, scratchFolder } from './tools.mjs';

const robots = ['io', 'ganymede', 'callisto'];
const decompressHandlers = { zstd: (bytes, size) => unzstd(bytes, new Uint8Array(Number(size))) };

/** Every message of a log by topic, decoded with the schemas that the log itself carries. */
async function readLog(path) {
  const bytes = readFileSync(path);
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const decoders = new Map(), topics = {};
  for await (const { channelId, data } of reader.readMessages({ validateCrcs: true })) {
    const { topic, schemaId, messageEncoding } = reader.channelsById.get(channelId);
    if (messageEncoding !== 'cdr') continue;
    if (!decoders.has(schemaId)) {
      decoders.set(schemaId, new MessageReader(definitionsOf(reader.schemasById.get(schemaId))));
    }
    (topics[topic] ??= []).push(decoders.get(schemaId).readMessage(data));
  }
  return topics;
}

describe('a headless minute', () => {
  let done, info, topics, junit;
  before(async () => {
    const cwd = scratchFolder({ after: (leave) => process.on('exit', leave) }), domain = freshDomain();
    done = galilean(['demo', '--port', String(await freePort()), '--headless-for', '60', '--record', 'run.mcap', '--expect', 'office', '--junit', 'out.xml'], { domain, cwd, timeout: 180_000 });
    // 3: a message was lost, or the machine was so slow that nothing was heard for a while.
    assert.ok([0, 3].includes(done.status), done.stdout + done.stderr);
    junit = readFileSync(`${cwd}/out.xml`, 'utf8');
    info = JSON.parse(galilean(['log', 'info', 'run.mcap', '--json'], { cwd }).stdout);
    topics = await readLog(`${cwd}/run.mcap`);
  });

  test('works, and its log is whole', () => {
    assert.match(done.stdout, /The team worked\./);
    assert.equal(info.recovered, false);
    assert.ok(info.duration_seconds > 55, `${info.duration_seconds} s`);
  });

  test('does what is expected of it', () => {
    assert.match(junit, /<testsuites tests="\d{2}" failures="0" errors="\d+">/);
    assert.match(junit, new RegExp(`errors="${done.status === 0 ? '0' : '[1-9]'}`));
    for (const robot of robots) assert.match(junit, new RegExp(`<testcase classname="${robot}" name="[^"]*never it is out of service`));
    assert.match(done.stdout, /never it is out of service/);
  });

  for (const robot of robots)
    test(`${robot} is there all the time, moves, and changes its state`, () => {
      const states = topics[`/${robot}/state`];
      assert.ok(states.length > 500, `${states.length} states`);
      assert.ok(new Set(states.map((state) => state.state)).size >= 3);
      const place = (state) => [state.x_m, state.y_m];
      const farthest = Math.max(...states.map((state) => Math.hypot(...place(state).map((v, i) => v - place(states[0])[i]))));
      assert.ok(farthest > 0.5, `${farthest} m from its start at most`);
      const transitions = topics[`/${robot}/transition`];
      assert.ok(transitions.length >= 2);
      for (const { from_state: from, to_state: to, cause } of transitions) assert.ok(to && cause, `${from} → ${to}: ${cause}`);
      assert.ok(topics[`/${robot}/variables`].at(-1).items.length > 5);
      assert.match(topics[`/${robot}/program`].at(-1).name, /^office_cleanup/);
    });

  test('the referee counts, and the monitor maps', () => {
    assert.ok(topics['/referee/score'].length > 10);
    assert.ok(topics['/team/objects'].at(-1).objects.length > 0);
  });
});
