// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { countedOf, memoryLine, Outcomes, recordedOf } from './soak_summary.mjs';

test('a fault is told with how often it was made, how often that went wrong, and how soon all was well', () => {
  const outcomes = new Outcomes();
  outcomes.note('a cable', 0.5);
  outcomes.note('a cable', 2.25);
  outcomes.note('a cable', undefined);
  outcomes.note('a disk', 1);
  assert.deepEqual(outcomes.lines(), ['fault: a cable: made 3 times, 1 of them wrong, well again after 2.3 s at most',
    'fault: a disk: made 1 times, 0 of them wrong, well again after 1.0 s at most']);
});

test('memory is told first and last', () => {
  assert.equal(memoryLine('io', undefined), 'memory of io: too few samples');
  const judged = { flat: false, first_bytes: 10 << 20, last_bytes: 20 << 20, bytes_per_hour: 5 << 20 };
  assert.equal(memoryLine('io', judged), 'memory of io: 10.0 MB at first, 20.0 MB at last, 5.00 MB more an hour: it grows');
});

test('what a recorder says that it lost is added up', () => {
  const words = `soak.mcap: 12345 messages of 40 topics in 7200.0 s, 120.0 MB
galilean-record: /io/state lost 2 of 500 messages of io, 1 of them because the recorder was too slow
galilean-record: /io/variables lacks, for want of room on the disk, 7 of 500 messages of io
`;
  assert.deepEqual(recordedOf(words), { recorded: 12345, lost: 9 });
  assert.deepEqual(recordedOf('soak.mcap: 1 message of 1 topic in 1.0 s, 0.1 MB\n'), { recorded: 1, lost: 0 });
});

test('what the monitor counts is added up by its name', () => {
  const metrics = `# HELP galilean_refused_messages_total Messages
galilean_refused_messages_total{topic="/a",reason="it is none"} 3
galilean_refused_messages_total{topic="/b",reason="it is none"} 4
galilean_limit_reached_total{limit="pings"} 0
galilean_websocket_superseded_total 9
galilean_http_requests_total 100
`;
  assert.deepEqual([...countedOf(metrics)], [['galilean_refused_messages_total', 7], ['galilean_websocket_superseded_total', 9]]);
});
