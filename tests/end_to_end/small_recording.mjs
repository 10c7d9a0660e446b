// SPDX-License-Identifier: BSD-3-Clause
// A recording that a test makes, by the writer that MCAP's authors wrote: 20 s of one robot.
import { McapWriter } from '../logs/tools.mjs';

export const START_NS = 1_700_000_000_000_000_000n;

/** What McapWriter writes to. */
class Memory {
  parts = [];
  size = 0n;
  async write(bytes) {
    this.parts.push(Buffer.from(bytes));
    this.size += BigInt(bytes.length);
  }
  position() {
    return this.size;
  }
}

/** Ten states a second, by two writers in turn, and a transition each second: 220 messages. */
export async function makeRecording() {
  const to = new Memory();
  const writer = new McapWriter({ writable: to, chunkSize: 600 });
  await writer.start({ profile: 'ros2', library: 'test' });
  const schema = (name) => writer.registerSchema({ name, encoding: 'ros2msg', data: new TextEncoder().encode('uint8 number') });
  const channel = async (topic, schemaId, process) =>
    writer.registerChannel({ schemaId, topic, messageEncoding: 'cdr', metadata: new Map([['process', process]]) });
  const state = await schema('galilean_msgs/msg/RobotState'), transition = await schema('galilean_msgs/msg/Transition');
  const states = [await channel('/io/state', state, 'first'), await channel('/io/state', state, 'second')];
  const transitions = await channel('/io/transition', transition, 'first');
  await channel('/io/sightings', await schema('galilean_msgs/msg/Sightings'), 'first');
  const write = (channelId, sequence, logTime) =>
    writer.addMessage({ channelId, sequence, logTime, publishTime: logTime, data: new Uint8Array([0, 1, 0, 0, sequence % 256]) });
  for (let i = 0; i < 200; ++i) {
    const logTime = START_NS + BigInt(i) * 100_000_000n;
    if (i % 10 === 0) await write(transitions, i, logTime);
    await write(states[i < 100 ? 0 : 1], i, logTime);
  }
  await writer.end();
  return Buffer.concat(to.parts);
}
