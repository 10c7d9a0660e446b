// SPDX-License-Identifier: BSD-3-Clause
// The recordings of a monitor's folder: listed, read by ranges, put there, and played to one viewer, who
// pauses and goes to any instant. No name leads out of the folder.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, unlinkSync, utimesSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { connect as connectTcp } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { within } from '../tools/patience.mjs';
import { objections } from './openapi.mjs';
import { eventually, freshDomain, getJson, Running } from './tools.mjs';
import { replay } from './replay_client.mjs';
import { makeRecording, START_NS } from './small_recording.mjs';

/** As a browser does not: without looking at the path. */
const raw = (url, path, { method = 'GET', headers = {}, body } = {}) => within(new Promise((resolve, reject) => {
  const { hostname, port } = new URL(url);
  const asked = request({ hostname, port, path, method, headers }, (response) => {
    const parts = [];
    response.on('data', (part) => parts.push(part)).on('end', () => resolve({ status: response.statusCode, headers: response.headers, body: Buffer.concat(parts) }));
  }).on('error', reject);
  asked.end(body);
}), () => `an answer to ${method} ${path}`);

/** Where the chunk of that number begins in a recording. */
function chunkIn(bytes, number) {
  const [headBytes, chunk] = [9, 6];
  for (let at = 8; ; at += headBytes + Number(bytes.readBigUInt64LE(at + 1))) if (bytes[at] === chunk && number-- === 0) return at;
}

describe('a folder of recordings', () => {
  const leaving = [];
  const all = { after: (leave) => leaving.push(leave) };
  const leaveAll = async () => { for (const leave of leaving.splice(0)) await leave(); };
  after(leaveAll);
  before(() => start().catch((error) => leaveAll().finally(() => { throw error; })));

  let cwd, folder, url, token, run;

  async function start() {
    cwd = mkdtempSync(join(tmpdir(), 'galilean-recordings-'));
    folder = join(cwd, 'recordings');
    mkdirSync(folder);
    run = await makeRecording();
    writeFileSync(join(folder, 'run.mcap'), run);
    utimesSync(join(folder, 'run.mcap'), 1.8e9, 1.8e9);
    writeFileSync(join(cwd, 'secret.mcap'), run);
    const monitor = new Running(all, ['monitor', '--listen', '127.0.0.1:0', '--data', cwd, '--recordings', folder], { domain: freshDomain(), cwd });
    all.after(() => rmSync(cwd, { recursive: true, force: true }));
    [url] = await monitor.line(/http:\/\/127\.0\.0\.1:\d+/);
    token = (name) => readFileSync(join(cwd, `${name}.token`), 'utf8').trim();
  }

  const put = (name, body, bearer = token('operator')) =>
    raw(url, `/api/recordings/${name}`, { method: 'PUT', body, headers: { 'content-length': body.length, ...(bearer && { authorization: `Bearer ${bearer}` }) } });
  const listed = async () => Object.fromEntries((await getJson(`${url}/api/recordings`)).recordings.map((each) => [each.name, each]));

  test('is listed, the newest first, with what each holds', async () => {
    writeFileSync(join(folder, 'older.mcap'), run.subarray(0, run.length / 2));
    utimesSync(join(folder, 'older.mcap'), 1.7e9, 1.7e9);
    const answer = await fetch(`${url}/api/recordings`);
    assert.deepEqual(await objections('GET', '/api/recordings', answer.clone()), []);
    const { folder: named, recordings } = await answer.json();
    assert.equal(named, folder);
    assert.deepEqual(recordings.map(({ name }) => name), ['run.mcap', 'older.mcap']);
    const [whole, cut] = recordings;
    assert.deepEqual([whole.bytes, whole.messages, whole.robots, whole.complete], [run.length, 220, ['io'], true]);
    assert.ok(Math.abs(whole.start - Number(START_NS)) < 1000, 'as near as a number of JavaScript is');
    assert.equal(whole.modified, '2027-01-15T08:00:00.000Z');
    assert.equal(cut.complete, false);
    assert.ok(cut.messages > 0 && cut.messages < 220, `${cut.messages}`);
    unlinkSync(join(folder, 'older.mcap'));
  });

  test('says of each that cannot be opened why', async () => {
    writeFileSync(join(folder, 'empty.mcap'), '');
    writeFileSync(join(folder, 'notes.mcap'), 'no recording at all');
    mkdirSync(join(folder, 'below.mcap'));
    symlinkSync('../secret.mcap', join(folder, 'link.mcap'));
    const now = await listed();
    for (const [name, words] of [['empty.mcap', /is empty/], ['notes.mcap', /is not an MCAP file/], ['below.mcap', /is a folder/], ['link.mcap', /leads out/]]) {
      assert.match(now[name].why, words);
      const { status, closed } = await refusedReplay(name);
      assert.match(status, words);
      assert.equal(closed.code, 1008);
      assert.ok(status.startsWith(closed.reason.slice(0, 40)), closed.reason);
    }
  });

  async function refusedReplay(name) {
    const viewer = await replay(all, url, name);
    const { message } = await viewer.text('status');
    return { status: message, closed: await viewer.closed };
  }

  test('gives files whole and in parts', async () => {
    const whole = await fetch(`${url}/recordings/run.mcap`);
    assert.equal(whole.status, 200);
    assert.equal(whole.headers.get('accept-ranges'), 'bytes');
    assert.equal(whole.headers.get('access-control-allow-origin'), '*');
    assert.match(whole.headers.get('access-control-expose-headers'), /Content-Range/);
    assert.deepEqual(Buffer.from(await whole.arrayBuffer()), run);

    const head = await fetch(`${url}/recordings/run.mcap`, { method: 'HEAD' });
    assert.deepEqual([head.status, head.headers.get('content-length')], [200, String(run.length)]);
    assert.equal((await head.arrayBuffer()).byteLength, 0);

    const size = run.length;
    for (const [range, from, to] of [['0-7', 0, 8], [`${size - 8}-`, size - 8, size], ['-8', size - 8, size], [`100-${size + 100}`, 100, size]]) {
      const part = await fetch(`${url}/recordings/run.mcap`, { headers: { range: `bytes=${range}` } });
      assert.equal(part.status, 206, range);
      assert.equal(part.headers.get('content-range'), `bytes ${from}-${to - 1}/${size}`);
      assert.deepEqual(Buffer.from(await part.arrayBuffer()), run.subarray(from, to), range);
    }
    const beyond = await fetch(`${url}/recordings/run.mcap`, { headers: { range: `bytes=${size}-` } });
    assert.deepEqual([beyond.status, beyond.headers.get('content-range')], [416, `bytes */${size}`]);
    assert.deepEqual(await objections('GET', '/recordings/{name}', beyond), []);

    const etag = whole.headers.get('etag');
    const part = (ifRange) => fetch(`${url}/recordings/run.mcap`, { headers: { range: 'bytes=0-0', 'if-range': ifRange } });
    assert.equal((await part(etag)).status, 206);
    assert.equal((await part('"another"')).status, 200);
    assert.equal((await fetch(`${url}/recordings/run.mcap`, { headers: { 'if-none-match': etag } })).status, 304);
  });

  test('is read by pages of other sites with a token alone', async () => {
    const origin = 'https://viewer.example';
    const ask = (path, options = {}) => raw(url, path, { ...options, headers: { origin, ...options.headers } });
    const without = await ask('/recordings/run.mcap');
    assert.equal(without.status, 401);
    assert.equal(without.headers['access-control-allow-origin'], '*', 'so that the page can read why');
    const read = await ask(`/recordings/run.mcap?token=${token('viewer')}`, { headers: { range: 'bytes=0-7' } });
    assert.deepEqual([read.status, read.headers['access-control-allow-origin']], [206, '*']);
    const asked = await ask('/recordings/run.mcap', { method: 'OPTIONS', headers: { 'access-control-request-headers': 'range' } });
    assert.equal(asked.status, 204);
    assert.equal(asked.headers['content-length'], undefined, 'RFC 9110, 8.6');
    assert.match(asked.headers['access-control-allow-headers'], /range/);
    assert.equal((await ask(`/api/recordings?token=${token('operator')}`)).status, 403);
  });

  test('has no name that leads out of it', async () => {
    for (const name of ['../secret.mcap', '..%2Fsecret.mcap', '%2e%2e/secret.mcap', '%2Fetc%2Fpasswd', 'link.mcap', '.', '..', '', '.hidden.mcap', 'run.mcap%00.mcap', 'below.mcap']) {
      const answer = await raw(url, `/recordings/${name}`);
      assert.equal(answer.status, 404, name);
      assert.match(answer.headers['content-type'], /problem/, name);
    }
  });

  test('takes a recording from who may steer, whole or not at all', async () => {
    assert.equal((await put('new.mcap', run, token('viewer'))).status, 403);
    assert.equal((await put('new.mcap', run, '')).status, 403);
    const kept = await put('new.mcap', run);
    assert.equal(kept.status, 201, `${kept.body}`);
    assert.deepEqual(readFileSync(join(folder, 'new.mcap')), run);
    assert.equal((await listed())['new.mcap'].messages, 220);
    assert.equal((await put('new.mcap', run)).status, 409);
    const MAGIC_BYTES = 8;
    for (const [name, body] of [['text.mcap', Buffer.from('no recording')], ['eight.mcap', run.subarray(0, MAGIC_BYTES)], ['junk.mcap', Buffer.concat([run.subarray(0, MAGIC_BYTES), Buffer.alloc(5000, 0x5a)])]]) {
      const refused = await put(name, body);
      assert.equal(refused.status, 422, name);
      assert.match(JSON.parse(refused.body).detail, new RegExp(`^'${name}' .*\\.$`));
    }
    const cut = await put('cut.mcap', run.subarray(0, run.length / 2));
    assert.equal(cut.status, 201, `${cut.body}`);
    const { complete, note } = JSON.parse(cut.body);
    assert.equal(complete, false);
    assert.match(note, /^'cut\.mcap' was kept, but is not whole: \d+ messages of it can be read/);
    for (const name of ['a%E2%80%AEb.mcap', 'a%E2%80%8B.mcap', '%20a.mcap', '.a.mcap', 'a%5Cb.mcap']) assert.equal((await put(name, run)).status, 400, name);
    assert.equal((await put('..%2Fnew.mcap', run)).status, 400);
    assert.equal((await put('new.txt', run)).status, 400);
    const huge = await raw(url, '/api/recordings/huge.mcap', { method: 'PUT', headers: { authorization: `Bearer ${token('operator')}`, 'content-length': 1e12, expect: '100-continue' } }).catch(() => undefined);
    if (huge) assert.equal(huge.status, 413);
    assert.ok(!readdirSync(folder).some((name) => name.endsWith('.part')), 'no draft is left');
  });

  test('keeps nothing of an upload that breaks off', async () => {
    const { hostname, port } = new URL(url);
    const socket = connectTcp({ host: hostname, port });
    await once(socket, 'connect');
    socket.write(`PUT /api/recordings/broken.mcap HTTP/1.1\r\nHost: ${hostname}:${port}\r\nAuthorization: Bearer ${token('operator')}\r\nContent-Length: 1000000\r\n\r\n`);
    socket.write(run);
    await eventually(() => readdirSync(folder).some((name) => name.startsWith('.broken.mcap.')));
    socket.destroy();
    await eventually(() => !readdirSync(folder).some((name) => name.includes('broken')));
  });

  test('plays one to a viewer, who goes where he wants', async (t) => {
    const viewer = await replay(t, url, 'run.mcap');
    const info = await viewer.text('serverInfo');
    assert.deepEqual(info.capabilities.sort(), ['playbackControl', 'time']);
    assert.match(info.name, /^run\.mcap, recorded 2023-11-14T22:13:20/);
    assert.deepEqual([info.dataStartTime, info.dataEndTime], [{ sec: 1700000000, nsec: 0 }, { sec: 1700000019, nsec: 900000000 }]);
    const { channels } = await viewer.text('advertise');
    assert.deepEqual(channels.map(({ topic }) => topic).sort(), ['/io/sightings', '/io/state', '/io/transition'], 'the two writers of a topic are one channel');

    viewer.control({ pause: true, id: 'stop' });
    await viewer.state('stop');
    await viewer.subscribe(channels.map(({ id }) => id));

    // As soon as a seek is answered, what was so then comes: one message of a state, however old, and nothing that is later.
    for (const at_s of [15.05, 3.05, 12.05]) {
      const sought = await viewer.seek(at_s, { pause: true });
      assert.deepEqual([sought.status, sought.did_seek, sought.now_s], ['paused', true, at_s]);
      const came = await viewer.settled();
      assert.ok(came.every((each) => each.at_s < at_s), `${at_s}`);
      const of = (topic) => came.filter((each) => channels.find(({ id }) => id === each.subscription).topic === topic).map(({ at_s: time }) => time);
      assert.deepEqual(of('/io/state'), [at_s - 0.05].map((each) => Number(each.toFixed(3))));
      assert.equal(of('/io/transition').length, Math.floor(at_s) + 1);
    }
    // A step of the page: on by 100 ms, and still paused.
    await viewer.seek(12.15, { pause: true });
    assert.equal((await viewer.settled()).filter(({ at_s }) => at_s === 12.1).length >= 1, true);
    assert.equal(viewer.clock_s, 12.15);

    // From the start to the end each message comes once, in order, and then it is over.
    await viewer.seek(0, { pause: true });
    await viewer.settled();
    viewer.forget();
    viewer.control({ pause: false, speed: 100, id: 'go' });
    await viewer.state('go');
    await viewer.until((state) => state.status === 'ended');
    assert.equal(viewer.messages.length, 220);
    assert.deepEqual(viewer.messages.map(({ at_s }) => at_s), viewer.messages.map(({ at_s }) => at_s).sort((a, b) => a - b));
    viewer.control({ speed: 1000, id: 'too fast' });
    assert.equal((await viewer.state('too fast')).speed, 100);
    assert.match((await viewer.text('status')).message, /from 0\.1 to 100/);
  });

  test('begins where the address says', async (t) => {
    const viewer = await replay(t, url, 'run.mcap', '&at=10.05');
    const { channels } = await viewer.text('advertise');
    await viewer.subscribe([channels.find(({ topic }) => topic === '/io/state').id]);
    await viewer.until((state) => state.status === 'playing');
    await eventually(() => viewer.messages.length >= 2);
    assert.deepEqual(viewer.messages.slice(0, 2).map(({ at_s }) => at_s), [10, 10.1]);
    const { status, closed } = await refusedReplay('run.mcap&at=soon');
    assert.match(status, /number of seconds/);
    assert.equal(closed.code, 1008);
  });

  test('names what is damaged, with its time', async (t) => {
    const damaged = Buffer.from(run);
    damaged[chunkIn(run, 5) + 100] ^= 0xff;
    writeFileSync(join(folder, 'damaged.mcap'), damaged);
    const viewer = await replay(t, url, 'damaged.mcap');
    const { message, level } = await viewer.text('status');
    assert.ok(level >= 1);
    assert.match(message, /^'damaged\.mcap'.* from 2023-11-14T22:13:\S+Z to 2023-11-14T22:13:\S+Z/);
  });

  test('plays on though the file is deleted', async (t) => {
    writeFileSync(join(folder, 'gone.mcap'), run);
    const viewer = await replay(t, url, 'gone.mcap');
    const { channels } = await viewer.text('advertise');
    unlinkSync(join(folder, 'gone.mcap'));
    await viewer.subscribe(channels.map(({ id }) => id));
    viewer.control({ pause: false, speed: 100, id: 'go' });
    await viewer.until((state) => state.status === 'ended');
    assert.equal(viewer.messages.length, 220);
    assert.match((await refusedReplay('gone.mcap')).status, /There is no recording 'gone\.mcap' here/);
  });

  const replays = async () => Number(/^galilean_replays (\d+)$/m.exec(await (await fetch(`${url}/metrics`)).text())[1]);

  test('plays to eight viewers at once, counts them, and refuses a ninth', async (t) => {
    const eight = [];
    await eventually(async () => {  // those of the tests before may still be leaving
      for (const viewer of eight.splice(0)) viewer.leave();
      for (let i = 0; i < 8; ++i) eight.push(await replay(t, url, 'run.mcap'));
      const first = await Promise.all(eight.map((viewer) => viewer.first));
      return first.every(({ op }) => op === 'serverInfo');
    });
    const ninth = await refusedReplay('run.mcap');
    assert.match(ninth.status, /^8 replays run already/);
    assert.equal(await replays(), 8);
    eight[0].leave();
    await eventually(async () => (await replays()) === 7);
    await eventually(async () => {
      const again = await replay(t, url, 'run.mcap');
      return (await again.first).op === 'serverInfo';
    });
  });
});
