// SPDX-License-Identifier: BSD-3-Clause
// A recorded team, played again: the same bytes in the same order at the same times, no command twice, and
// never beside live robots of the same names.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import { McapIndexedReader, unzstd } from '../logs/tools.mjs';
import { eventually, freshDomain, galilean, getJson, programs, Running, scratchFolder, startTeam } from './tools.mjs';

const decompressHandlers = { zstd: (bytes, size) => unzstd(bytes, new Uint8Array(Number(size))) };

/** By topic, in their order: when each message was received, in seconds since the first, and its bytes. */
async function messagesOf(path) {
  const bytes = readFileSync(path);
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const topics = {};
  const first_ns = reader.statistics.messageStartTime;
  for await (const { channelId, data, logTime } of reader.readMessages({ validateCrcs: true }))
    (topics[reader.channelsById.get(channelId).topic] ??= []).push({ at_s: Number(logTime - first_ns) * 1e-9, bytes: Buffer.from(data) });
  return topics;
}

describe('a recorded team', () => {
  const leaving = [];
  const all = { after: (leave) => leaving.push(leave) };
  const leaveAll = async () => { for (const leave of leaving.splice(0)) await leave(); };
  after(leaveAll);
  const cwd = scratchFolder(all);
  const said = (args, options) => galilean(['replay', ...args], { cwd, ...options });

  // Where it fails, nobody calls `after`: what it has started would keep this process from its end.
  before(() => recordTeam().catch((error) => leaveAll().finally(() => { throw error; })));

  async function recordTeam() {
    const { team, domain, url } = await startTeam(all);
    await eventually(async () => (await getJson(`${url}/api/status`)).robots.length === 3);
    const recorder = new Running(all, ['record', '--out', 'run.mcap', '--duration', '6'], { domain, cwd });
    await eventually(() => existsSync(`${cwd}/run.mcap`) && statSync(`${cwd}/run.mcap`).size > 100_000);
    for (const command of ['hold', 'resume']) {
      const told = galilean([command, '--team'], { domain, cwd });
      assert.equal(told.status, 0, told.stderr);
    }
    await recorder.exited;

    const refused = said(['run.mcap'], { domain });
    assert.equal(refused.status, 1);
    assert.match(refused.stderr, /callisto, ganymede, io, referee and simulation are live in this DDS domain.*--anyway\n$/);
    assert.equal(refused.stdout, '');
    await team.stop();
  }

  test('arrives as it was: every message, in order, with the same bytes, at the same time', async (t) => {
    const domain = freshDomain();
    const recorder = new Running(t, ['record', '--out', 'again.mcap'], { domain, cwd });
    const played = said(['run.mcap'], { domain });
    assert.equal(played.status, 0, played.stderr);
    assert.match(played.stdout, /not played: .*\/team\/command/);
    await recorder.stop();

    const [then, again] = [await messagesOf(`${cwd}/run.mcap`), await messagesOf(`${cwd}/again.mcap`)];
    assert.ok(then['/team/command'].length > 0);
    assert.equal(again['/team/command'], undefined);
    const topics = Object.keys(then).filter((topic) => topic !== '/team/command');
    assert.ok(topics.length > 30, topics.join(' '));
    for (const topic of topics.filter((each) => !each.endsWith('/compressed'))) {
      assert.equal(again[topic]?.length, then[topic].length, topic);
      then[topic].forEach(({ bytes }, i) => assert.ok(bytes.equals(again[topic][i].bytes), `message ${i} of ${topic}`));
    }
    const late_s = then['/io/state'].map(({ at_s }, i) => Math.abs(again['/io/state'][i].at_s - at_s)).sort((a, b) => a - b);
    assert.ok(late_s[Math.floor(late_s.length / 2)] < 0.2, `half of the states are off by ${late_s[Math.floor(late_s.length / 2)]} s`);
  });

  test('is a team to the monitor, which draws a map of its own', async (t) => {
    const domain = freshDomain();
    const folder = scratchFolder(t);
    const monitor = new Running(t, ['monitor', '--listen', '127.0.0.1:0', '--data', folder], { domain, cwd: folder });
    const [url] = await monitor.line(/http:\/\/127\.0\.0\.1:\d+/);
    const replay = new Running(t, ['replay', `${cwd}/run.mcap`, '--loop', '--rate', '4'], { domain, cwd });
    const first = await eventually(async () => {
      const { robots } = await getJson(`${url}/api/status`);
      return robots.length === 3 && robots.every(({ state, silent }) => state && !silent) && robots;
    });
    assert.deepEqual(first.map(({ name }) => name), ['callisto', 'ganymede', 'io']);
    await replay.line(/played \d+ messages[^]*played \d+ messages/);
    const listener = galilean(['record', '--out', 'monitored.mcap', '--duration', '2', '--topics', 'objects'], { domain, cwd });
    assert.equal(listener.status, / lost \d+ of /.test(listener.stderr) ? 3 : 0, listener.stderr);
    const { '/team/objects': maps } = await messagesOf(`${cwd}/monitored.mcap`);
    assert.ok(maps.length <= 12, `${maps.length} maps in 2 s: two draw them`);
  });

  test('plays two of its robots beside one that is live, and nobody takes them for live', async (t) => {
    const { domain, url, link } = await startTeam(t, ['--robots', '1']);
    const robots = async () => (await getJson(`${url}/api/status`)).robots;
    const [{ name: live }] = await eventually(async () => { const all = await robots(); return all.length === 1 && all[0].state && all; });
    const names = ['callisto', 'ganymede', 'io'];
    const played = names.filter((name) => name !== live);
    assert.equal(played.length, 2, live);

    const refused = said(['run.mcap', '--robots', live], { domain });
    assert.equal(refused.status, 1);
    assert.ok(refused.stderr.startsWith(`galilean-replay: ${live} is live in this DDS domain`), refused.stderr);
    const unknown = said(['run.mcap', '--robots', 'ganimede'], { domain });
    assert.match(unknown.stderr, /no robot 'ganimede' is in it; did you mean 'ganymede'\?/);

    const replay = new Running(t, ['replay', `${cwd}/run.mcap`, '--robots', played.join(','), '--loop'], { domain, cwd });
    await replay.line(/live robots in this domain: .*\n/);
    assert.ok(replay.output.includes(`robots from the recording: ${played.join(' and ')}\nrobots left out of it: ${live}\nlive robots in this domain: ${live}\n`), replay.output);

    const together = await eventually(async () => {
      const all = await robots();
      return all.length === 3 && all.every(({ state, silent }) => state && !silent) && all;
    });
    assert.deepEqual(together.map(({ name, replayed }) => [name, replayed]), names.map((name) => [name, played.includes(name)]));
    const metrics = await (await fetch(`${url}/metrics`)).text();
    for (const name of names) assert.match(metrics, new RegExp(`^galilean_robot_replayed\\{robot="${name}"\\} ${Number(played.includes(name))}$`, 'm'));

    const json = (...args) => JSON.parse(galilean([...args, '--json'], { domain }).stdout);
    const topics = Object.fromEntries(json('list').map((each) => [each.topic, each]));
    for (const topic of [...names.map((name) => `/${name}/state`), '/referee/score', '/simulation/state']) assert.equal(topics[topic]?.writers, 1, topic);
    const writes = json('graph').find(({ participant }) => participant === 'replay').writes;
    assert.ok(played.every((name) => writes.includes(`/${name}/state`)), writes.join(' '));
    assert.ok(!writes.some((topic) => topic.startsWith(`/${live}/`) || /^\/(team|referee|simulation)\//.test(topic)), writes.join(' '));

    const picture = galilean(['top', '--once'], { domain }).stdout;
    for (const name of names)
      assert.equal(new RegExp(`${name} +replay: `).test(picture), played.includes(name), picture);

    const [, token] = link.split('token=');
    const push = (targets) => fetch(`${url}/api/push`, {
      method: 'POST', headers: { authorization: `Bearer ${token}` },
      body: JSON.stringify({ files: [{ path: 'office_cleanup.bhdl', text: readFileSync(`${programs}/office_cleanup.bhdl`, 'utf8') }], targets }),
    });
    const toPlayed = await push([played[0]]);
    assert.equal(toPlayed.status, 409);
    assert.match((await toPlayed.json()).detail, new RegExp(`^A recording plays '${played[0]}': the robot is not there`));

    await replay.stop();
    const after = await eventually(async () => { const all = await robots(); return all.filter(({ silent }) => silent).length === 2 && all; });
    assert.deepEqual(after.map(({ name, replayed }) => [name, replayed]), names.map((name) => [name, played.includes(name)]), 'who was played is no live robot that has fallen silent');
  });

  test('tells its time on /clock, as fast as it is played, and only where nobody else does', async (t) => {
    const domain = freshDomain();
    const told = (...args) => {
      const { status, stdout, stderr } = galilean(['echo', '/clock', '--json', ...args], { domain });
      assert.equal(status, 0, stderr);
      return stdout.trim().split('\n').map((line) => JSON.parse(line)).map(({ clock: { sec, nanosec } }) => sec + nanosec * 1e-9);
    };
    const replay = new Running(t, ['replay', `${cwd}/run.mcap`, '--clock', '20', '--rate', '0.5', '--loop'], { domain, cwd });
    await replay.line(/keys|topics/);
    const { start_ns, end_ns } = JSON.parse(galilean(['log', 'info', `${cwd}/run.mcap`, '--json'], { cwd }).stdout);
    const times = told('--count', '20');
    assert.ok(times.every((at) => at >= Number(start_ns) * 1e-9 - 0.001 && at <= Number(end_ns) * 1e-9 + 0.001), `${times} of ${start_ns} to ${end_ns}`);
    const steps = times.slice(1).map((at, i) => at - times[i]).sort((a, b) => a - b);
    assert.ok(Math.abs(steps[9] - 0.025) < 0.01, `half a 20th of a second is a step of it: ${steps}`);

    const second = said(['run.mcap', '--clock', '20'], { domain });
    assert.equal(second.status, 1);
    assert.match(second.stderr, /another process tells the time on \/clock in this DDS domain already/);
    const wrong = said(['run.mcap', '--clock', '0'], { domain });
    assert.equal(wrong.status, 2);
  });

  test('is played as far as it is whole, and says so', () => {
    const bytes = readFileSync(`${cwd}/run.mcap`);
    writeFileSync(`${cwd}/cut.mcap`, bytes.subarray(0, bytes.length / 2));
    const cut = said(['cut.mcap', '--rate', '20'], { domain: freshDomain() });
    assert.equal(cut.status, 3, cut.stderr);
    const [, whole] = /cut\.mcap was not closed properly; recovered (\d+) messages/.exec(cut.stdout);
    const [, played] = /played (\d+) messages/.exec(cut.stdout);
    assert.ok(Number(played) > 50 && Number(played) <= Number(whole), `${played} of ${whole}`);
  });

  test('says in a line what cannot be played', () => {
    writeFileSync(`${cwd}/notes.txt`, 'no recording');
    for (const [args, words] of [
      [['notes.txt'], /^galilean-replay: notes\.txt is not an MCAP file\n$/],
      [['nothing.mcap'], /^galilean-replay: nothing\.mcap cannot be read: .*\n$/],
      [['run.mcap', '--from', '600'], /^galilean-replay: --from 600\.0 s is behind the end of run\.mcap, which lasts \d+\.\d s\n$/],
    ]) {
      const { status, stderr } = said(args, { domain: freshDomain() });
      assert.equal(status, 1);
      assert.match(stderr, words);
    }
  });
});
