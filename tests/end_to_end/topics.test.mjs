// SPDX-License-Identifier: BSD-3-Clause
// The verbs that show what is on the wire, beside a robot that runs: list, echo, rate, info, graph, wait.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { freshDomain, galilean, startMonitor } from './tools.mjs';

test('scripts list, read, measure and await what is on the wire', { timeout: 120_000 }, async (t) => {
  const { domain } = await startMonitor(t);
  const said = (...args) => galilean([...args, '--json'], { domain });
  const json = (...args) => {
    const { status, stdout, stderr } = said(...args);
    assert.equal(status, 0, stderr);
    return stdout.trim().split('\n').map((line) => JSON.parse(line));
  };

  const [topics] = json('list');
  const state = topics.find(({ topic }) => topic === '/io/state');
  assert.deepEqual(state.types, ['galilean_msgs/msg/RobotState']);
  assert.equal(state.writers, 1);
  assert.ok(state.readers >= 1, JSON.stringify(state));

  const camera = topics.find(({ topic }) => topic === '/io/camera/compressed');
  assert.deepEqual([camera.writers, camera.readers], [1, 0]);

  const messages = json('echo', 'io/state', '--count', '2');
  assert.deepEqual(messages.map(({ robot }) => robot), ['io', 'io']);
  assert.ok(messages[1].tick > messages[0].tick);
  assert.deepEqual(json('echo', '/io/state', '--count', '1', '--field', 'robot'), ['io']);
  const text = galilean(['echo', 'io/state', '--count', '1'], { domain });
  assert.match(text.stdout, /^stamp:\n {2}sec: \d+\n {2}nanosec: \d+\nrobot: "io"\n/);

  const [rate] = json('rate', 'io/state', '--window', '2');
  assert.ok(rate.rate_hz > 1 && rate.rate_hz < 30, JSON.stringify(rate));
  assert.ok(rate.least_gap_s <= rate.mean_gap_s && rate.mean_gap_s <= rate.most_gap_s, JSON.stringify(rate));
  assert.ok(rate.bytes_per_s > 0);

  const [[info]] = json('info', 'io/state');
  assert.equal(info.topic, '/io/state');
  assert.equal(info.writers.length, 1);
  assert.equal(info.writers[0].qos.durability, 'transient-local');
  assert.deepEqual(info.mismatches, []);
  assert.ok(json('info', 'io')[0].length > 5);

  const [graph] = json('graph');
  assert.ok(graph.some(({ writes }) => writes.includes('/io/state')));
  assert.ok(graph.find(({ participant }) => participant === 'monitor').reads.includes('/io/state'));
  assert.match(galilean(['graph', '--format', 'dot'], { domain }).stdout, /-> "\/io\/state";/);

  assert.equal(json('wait', 'io/state.robot == "io" and io/state.tick >= 1', '--timeout', '20')[0].holds, true);
  const late = said('wait', 'io/state.robot == "callisto"', '--timeout', '1000ms');
  assert.equal(late.status, 1);
  assert.match(late.stderr, /^galilean wait: .* did not come true within \d+\.\d s\n$/);
  assert.equal(said('wait', 'io/state.robot = "io"').status, 2);

  const unknown = said('echo', 'io/sttae');
  assert.equal(unknown.status, 1);
  assert.match(unknown.stderr, /did you mean '\/io\/state'\?/);
});

test('where nobody is, a list says so', () => {
  const { status, stderr } = galilean(['list'], { domain: freshDomain() });
  assert.equal(status, 1);
  assert.match(stderr, /^galilean list: nobody writes or reads a topic; .*\n$/);
});
