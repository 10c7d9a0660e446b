// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { disagreement } from './stages/agreement.mjs';

const push = (status) => ({ id: '1', state: 'failed', hash: 'new', replies: [{ robot: 'io', status }] });
const io = (program_hash) => [{ name: 'io', program_hash }];

test('a push agrees with robots that run what it tells', () => {
  for (const status of ['running', 'confirmed']) assert.equal(disagreement(push(status), io('new')), undefined);
  for (const status of ['no_answer', 'received', 'rejected', 'rolled_back']) assert.equal(disagreement(push(status), io('old')), undefined);
  assert.equal(disagreement({ ...push('confirmed'), replies: [] }, io('old')), undefined);
});

test('a robot that runs what the push does not tell, or does not run what it tells, is named', () => {
  assert.match(disagreement(push('no_answer'), io('new')), /io does not run new, and it runs new/);
  assert.match(disagreement(push('confirmed'), io('old')), /io runs new, and it runs old/);
});
