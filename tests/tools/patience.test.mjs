// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { eventually, within } from './patience.mjs';

test('what is waited for in vain is named, with where', async () => {
  const never = () => false;
  await assert.rejects(eventually(never, 50), (late) => /waited 0\.05 s for \(\) => false/.test(late.message) && /patience\.test/.test(late.stack));
  await assert.rejects(within(new Promise(() => {}), () => 'a word', 50), /waited 0\.05 s for a word/);
  assert.equal(await eventually(async () => 7), 7);
});
