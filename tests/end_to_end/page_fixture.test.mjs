// SPDX-License-Identifier: BSD-3-Clause
// The stand-in for the monitor that the page's tests play against answers as the monitor is described.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { startFixture } from '../../web/tests/fixture/start.mjs';
import { objections } from './openapi.mjs';

describe("the page's stand-in for the monitor", () => {
  let fixture, url, files;

  const ask = async (operation, status, body, ...values) => {
    const [method, path] = operation.split(' ');
    const target = path.replace(/\{\w+\}/g, () => encodeURIComponent(values.shift()));
    const response = await fetch(url + target, body === undefined ? { method } : { method, body: JSON.stringify(body) });
    assert.equal(response.status, status, operation);
    const copy = response.clone();
    assert.deepEqual(await objections(method, path, response), []);
    return copy.json();
  };
  const broken = () => [{ path: 'broken.bhdl', text: 'nonsense\n' }];

  before(async () => {
    fixture = await startFixture({ ahead: 20, simulated: true, refusing: true });
    url = fixture.url;
    ({ files } = await ask('GET /api/programs/{name}', 200, undefined, 'sit_and_spin.bhdl'));
  });

  after(() => fixture.stop());

  test('tells what it knows', async () => {
    const { robots, score, refused_messages } = await ask('GET /api/status', 200);
    assert.deepEqual(robots.map(({ name }) => name), ['io', 'ganymede', 'callisto']);
    assert.equal(score.phase, 'running');
    assert.deepEqual(refused_messages.map(({ topic, messages }) => [topic, messages]), [['rt/stranger/state', 12]]);
    assert.equal((await ask('GET /api/programs', 200)).programs.length, 2);
    assert.ok((await ask('GET /api/strategies', 200)).strategies.length > 0);
    await ask('GET /api/programs/{name}', 404, undefined, 'none.bhdl');
  });

  test('tells what a recording exercised', async () => {
    const { programs: [program] } = await ask('GET /api/recordings/{name}/coverage', 200, undefined, 'office.mcap');
    const { visited, entered } = program.states.find(({ name }) => name === 'wander_for_trash');
    assert.ok(visited && entered > 0);
    assert.ok(program.conditions.some(({ taken }) => taken > 0) && program.conditions.some(({ taken }) => taken === 0));
    await ask('GET /api/recordings/{name}/coverage', 404, undefined, 'gone.mcap');
    await ask('GET /api/recordings/{name}/coverage', 422, undefined, 'broken.mcap');
  });

  test('checks a program', async () => {
    const right = await ask('POST /api/check', 200, { files, against: files });
    assert.equal(right.ok, true);
    assert.ok(right.machine.states.length > 5 && right.machine.transitions.length > 5);
    const wrong = await ask('POST /api/check', 200, { files: broken() });
    assert.equal(wrong.ok, false);
    assert.equal(wrong.diagnostics[0].line, 1);
  });

  test('pushes a program, keeps it, and refuses one with errors', async () => {
    const { hash, replies } = await ask('POST /api/push', 200, { files, targets: ['io'], author: 'tester' });
    assert.deepEqual(replies.map(({ robot }) => robot), ['io']);
    const { pushes } = await ask('GET /api/pushes', 200);
    assert.deepEqual(pushes.map((push) => push.hash), [hash]);
    assert.deepEqual((await ask('GET /api/pushed/{hash}', 200, undefined, hash)).files, files);
    assert.equal((await ask('POST /api/push', 422, { files: broken() })).diagnostics.length, 1);
  });

  test('obeys a word to robots', async () => {
    await ask('POST /api/command', 200, { kind: 'hold', targets: ['io'] });
    const { robots } = await ask('GET /api/status', 200);
    assert.deepEqual(robots.filter(({ held }) => held).map(({ name }) => name), ['io']);
  });

  test('takes orders about break points, and tells why not', async () => {
    await ask('POST /api/breaks', 200, { order: 'set', targets: ['io'], points: [{ from: 'start', to: 'wander_for_trash', kind: 'lock' }] });
    assert.match((await ask('POST /api/breaks', 400, { order: 'set' })).detail, /'points'/);
    await ask('POST /api/command', 200, { kind: 'step', targets: ['ganymede'] });
  });

  test('carries out what an instructor orders, and tells why not', async () => {
    const moved = await ask('POST /api/simulation/orders', 200, { order: 'move', subject: 'io', x_m: 1.5, y_m: 5 });
    assert.equal(moved.text, 'moved io to (1.50, 5.00) m');
    const { detail } = await ask('POST /api/simulation/orders', 409, { order: 'mend', subject: 'io', part: 'camera' });
    assert.match(detail, /not broken/);
  });
});
