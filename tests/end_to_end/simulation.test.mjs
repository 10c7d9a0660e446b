// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { connect, readerOf } from './foxglove_client.mjs';
import { objections } from './openapi.mjs';
import { eventually, freshDomain, galilean, getJson, processesIn, programs, scratchFolder, startTeam } from './tools.mjs';

function contest(...options) {
  const { status, stdout, stderr } = galilean(['sim', '--headless', '--scenario', 'office', '--json', ...options]);
  assert.equal(status, 0, stderr);
  return JSON.parse(stdout);
}

test('the same seed gives the same hash, another seed another', () => {
  const options = ['--robots', '3', '--duration', '60', '--seed'];
  const first = contest(...options, '1');
  assert.equal(contest(...options, '1').hash, first.hash);
  assert.notEqual(contest(...options, '2').hash, first.hash);
});

for (const program of ['office_cleanup', 'sit_and_spin']) {
  test(`three robots with ${program} clean the office in ten minutes`, (t) => {
    const result = contest('--robots', '3', '--duration', '600', '--seed', '1', '--bhdl', `${programs}/${program}.bhdl`);
    t.diagnostic(`${result.deposited} deposited, ${result.collisions} collisions, score ${result.score}, ` +
      `longest stuck ${result.longest_stuck_s} s, ${(result.simulated_seconds / result.wall_seconds).toFixed(0)} simulated seconds a second`);
    assert.ok(Math.abs(result.simulated_seconds - 600) < 1);
    assert.ok(result.deposited >= 22, `${result.deposited} deposited`);
    assert.ok(result.collisions <= 100, `${result.collisions} collisions`);
    assert.ok(result.longest_stuck_s <= 6, `stuck for ${result.longest_stuck_s} s`);
  });
}

test('what a simulation reads it does not write over', (t) => {
  const cwd = scratchFolder(t);
  const texts = { 'my.bhdl': 'include "parts.bhdl"\n', 'parts.bhdl': 'state: name: "alone" end\n' };
  for (const [name, text] of Object.entries(texts)) writeFileSync(`${cwd}/${name}`, text);
  symlinkSync('my.bhdl', `${cwd}/link`);
  for (const option of ['--trace', '--snapshot'])
    for (const written of ['./link', 'parts.bhdl']) {
      const { status, stderr } = galilean(['sim', '--bhdl', 'my.bhdl', '--duration', '1', option, written], { cwd });
      assert.equal(status, 2);
      assert.equal(stderr, `galilean-sim: ${written} is read here and cannot be written; choose another name\n`);
      for (const [name, text] of Object.entries(texts)) assert.equal(readFileSync(`${cwd}/${name}`, 'utf8'), text);
    }
});

test('a hundred robots have places in an office that grows, and one more is refused', () => {
  const result = contest('--robots', '100', '--duration', '0.5');
  assert.equal(result.robots.length, 100);
  const { status, stderr } = galilean(['sim', '--headless', '--robots', '101']);
  assert.equal(status, 2);
  assert.match(stderr, /from 1 to 100 robots, not 101, because a DDS domain has room for no more/);
});

test('a scenario that is none ends with one clear line', (t) => {
  const file = `${scratchFolder(t)}/bad.json`;
  writeFileSync(file, '{"name": "bad", "arena": {"width_m": "wide"}}');
  for (const scenario of [file, 'no_such_scenario']) {
    const { status, stderr } = galilean(['sim', '--headless', '--scenario', scenario]);
    assert.equal(status, 2);
    assert.equal(stderr.trim().split('\n').length, 1, stderr);
    assert.ok(stderr.includes(scenario), stderr);
  }
});

test('an instructor pauses, moves and breaks while a team runs, and all of it is recorded', async (t) => {
  const { team, domain, cwd, url, link } = await startTeam(t, ['--robots', '1', '--record', 'taught.mcap']);
  const said = (...args) => galilean(['sim', 'ctl', ...args], { domain });
  const done = (...args) => {
    const { status, stdout, stderr } = said(...args);
    assert.equal(status, 0, stderr);
    return stdout.trim();
  };
  const truth = () => JSON.parse(done('truth'));
  const problems = async () => (await getJson(`${url}/api/status`)).robots[0]?.problems ?? [];
  const quiet = async () => (await problems()).length === 0 && (await getJson(`${url}/api/status`)).robots.length === 1;
  await eventually(quiet);

  assert.equal(done('pause'), 'paused the simulation');
  const { step } = truth();
  await eventually(async () => (await problems()).some((sentence) => /microcontroller/.test(sentence)));
  assert.equal(truth().step, step);
  assert.equal(done('move', 'io', '6.2', '4.6'), 'moved io to (6.20, 4.60) m');
  const io = truth().bodies.find(({ name }) => name === 'io');
  assert.ok(Math.hypot(io.x_m - 6.2, io.y_m - 4.6) < 1e-3, JSON.stringify(io));
  done('go-on');
  await eventually(quiet);

  done('break', 'io', 'camera');
  await eventually(async () => (await problems()).some((sentence) => /camera|picture/i.test(sentence)));
  done('mend', 'io', 'camera');
  await eventually(quiet);

  done('break', 'io', 'board');
  await eventually(async () => (await problems()).some((sentence) => /microcontroller/.test(sentence)));
  done('mend', 'io', 'board');
  await eventually(quiet);

  const refused = said('move', 'io', '0', '0');
  assert.equal(refused.status, 1);
  assert.match(refused.stderr, /^galilean sim ctl: io cannot stand at .*a wall\n$/);

  await t.test('over HTTP as well, and whoever listens to the monitor hears of it', async (inner) => {
    const headers = { authorization: `Bearer ${new URL(link).hash.replace('#token=', '')}` };
    const order = async (status, body) => {
      const answer = await fetch(`${url}/api/simulation/orders`, { method: 'POST', headers, body: JSON.stringify(body) });
      assert.deepEqual(await objections('POST', '/api/simulation/orders', answer.clone()), []);
      assert.equal(answer.status, status);
      return answer.json();
    };
    const { client, next, channel } = connect(inner, url);
    const events = await channel('/simulation/event');
    client.subscribe(events.id);
    const told = await order(200, { order: 'move', subject: 'io', x_m: 6.2, y_m: 4.6, author: 'Ada' });
    assert.equal(told.text, 'moved io to (6.20, 4.60) m');
    const event = (message) => readerOf(events).readMessage(message.data);
    const heard = event(await next('message', (message) => event(message).order_id === told.order_id));
    assert.deepEqual([heard.author, heard.order, heard.done], ['Ada', 'move', true]);
    const { detail } = await order(409, { order: 'move', subject: 'io', x_m: 0, y_m: 0 });
    assert.match(detail, /^io cannot stand at .*a wall\.$/);
  });
  assert.equal((await team.stop()).code, 0);
  const { stdout } = galilean(['log', 'info', 'taught.mcap'], { cwd });
  assert.match(stdout, /\/simulation\/event/);
});

test('a robot whose program is frozen is braked by its board, and drives on when it is thawed', { timeout: 300_000 }, async (t) => {
  let robot;
  t.after(() => robot && process.kill(robot.pid, 'SIGCONT'));  // before the team is ended
  const { domain } = await startTeam(t, ['--robots', '1']);
  const look = () => {
    const { status, stdout, stderr } = galilean(['sim', 'ctl', 'truth'], { domain });
    assert.equal(status, 0, stderr);
    const { step, bodies } = JSON.parse(stdout);
    return { step, ...bodies.find(({ name }) => name === 'io') };
  };
  const after = (begin, seconds) => eventually(async () => {
    const seen = look();
    return seen.step >= begin.step + seconds * 100 && seen;
  });
  const travelled = (from, to) => Math.hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  const drives = async () => {
    const from = look();
    return travelled(from, await after(from, 0.3)) > 0.02;
  };
  await eventually(drives);
  robot = processesIn(domain).find(({ command }) => /galilean-robot .*--name io/.test(command));
  process.kill(robot.pid, 'SIGSTOP');
  const stands = await after(look(), 0.5);
  assert.ok(travelled(stands, await after(stands, 1)) < 0.002);
  process.kill(robot.pid, 'SIGCONT');
  await eventually(drives);
});

test('where no simulation runs, an order says so', () => {
  const { status, stderr } = galilean(['sim', 'ctl', 'pause'], { domain: freshDomain() });
  assert.equal(status, 1);
  assert.match(stderr, /^galilean sim ctl: no simulation is heard; .*\n$/);
});
