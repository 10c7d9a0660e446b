// SPDX-License-Identifier: BSD-3-Clause
// The monitor behind TLS: the page, the API, WebSockets and commands, and how its certificate is known.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { mkdirSync, readFileSync, renameSync, statSync, writeFileSync } from 'node:fs';
import { request as plainRequest } from 'node:http';
import { request } from 'node:https';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { within } from '../tools/patience.mjs';
import { eventually, freshDomain, galilean, root, Running, scratchFolder } from './tools.mjs';

const { WebSocket } = createRequire(`${root}tests/node/`)('ws');

async function startEncrypted(t, cwd = scratchFolder(t)) {
  const monitor = new Running(t, ['monitor', '--listen', '127.0.0.1:0', '--tls', '--data', cwd], { domain: freshDomain(), cwd });
  const [url, port] = await monitor.line(/https:\/\/127\.0\.0\.1:(\d+)/);
  const [, fingerprint] = await monitor.line(/fingerprint, .*: ([0-9A-F:]{95})\n/);
  return { monitor, cwd, url, port, fingerprint, ca: readFileSync(join(cwd, 'certificate.pem')) };
}

/** The answer to a request, with its body and the certificate's fingerprint. */
const ask = (send, url, options = {}, body) =>
  within(new Promise((resolve, reject) => {
    send(url, { agent: false, ...options }, (response) => {
      const parts = [];
      const fingerprint = response.socket.getPeerCertificate?.().fingerprint256;
      response.on('data', (part) => parts.push(part))
        .on('end', () => resolve({ status: response.statusCode, headers: response.headers, fingerprint, body: Buffer.concat(parts) }));
    }).on('error', reject).end(body);
  }), () => `an answer from ${url}`);

test('the page and the API are served over TLS by a certificate whose fingerprint is printed', async (t) => {
  const { url, cwd, ca, fingerprint, monitor } = await startEncrypted(t);
  assert.equal(statSync(join(cwd, 'certificate.key')).mode & 0o777, 0o600);
  const status = await ask(request, `${url}/api/status`, { ca });
  assert.deepEqual([status.status, status.fingerprint], [200, fingerprint]);
  await assert.rejects(ask(request, `${url}/api/status`), /self.signed/);

  const page = await ask(request, url, { ca });
  const sizes = [];
  for (const asset of new Set(page.body.toString().match(/assets\/[\w.-]+/g))) {
    const { body, headers } = await ask(request, `${url}/${asset}`, { ca });
    assert.equal(body.length, Number(headers['content-length']), asset);
    sizes.push(body.length);
  }
  assert.ok(Math.max(...sizes) > 10_000, `${sizes}`);

  const bearer = { authorization: `Bearer ${readFileSync(join(cwd, 'operator.token'), 'utf8').trim()}` };
  const program = JSON.stringify({ files: [{ path: 'a.bhdl', text: 'states:\n  state:\n    name: "start"\n  end\nend\n' }] });
  const checked = await ask(request, `${url}/api/check`, { ca, method: 'POST', headers: bearer }, program);
  assert.equal(JSON.parse(checked.body).ok, true);

  const own = { origin: url }, other = { origin: url.replace('https:', 'http:') };
  assert.equal((await ask(request, `${url}/api/status`, { ca, headers: own })).status, 200);
  assert.equal((await ask(request, `${url}/api/status`, { ca, headers: other })).status, 403);
  assert.deepEqual(await monitor.stop(), { code: 0, signal: null });
});

test('WebSockets run over TLS', async (t) => {
  const { url, ca } = await startEncrypted(t);
  const socket = new WebSocket(`${url.replace('https', 'wss')}/ws`, ['foxglove.websocket.v1'], { ca });
  t.after(() => socket.terminate());
  const [first] = await within(once(socket, 'message'), () => 'a first message');
  assert.equal(JSON.parse(first).op, 'serverInfo');
  socket.close();
  const [code] = await within(once(socket, 'close'), () => 'the end');
  assert.equal(code, 1000);
});

test('plain HTTP on a port of TLS gets one clear sentence', async (t) => {
  const { port } = await startEncrypted(t);
  const { status, body } = await ask(plainRequest, `http://127.0.0.1:${port}/api/status`);
  assert.equal(status, 400);
  assert.equal(JSON.parse(body).detail, 'This monitor speaks TLS here: open https:// and not http://.');
});

test('commands know the certificate by its fingerprint, by its file, or as their own', async (t) => {
  const cwd = join(process.env.XDG_STATE_HOME, 'galilean');
  mkdirSync(cwd, { recursive: true });
  const { url, fingerprint } = await startEncrypted(t, cwd);
  const programs = (...options) => galilean(['programs', 'list', '--json', '--monitor', url, ...options]);
  const listed = (...options) => {
    const { status, stdout, stderr } = programs(...options);
    assert.equal(status, 0, stderr);
    assert.deepEqual(JSON.parse(stdout).pushes, []);
  };
  listed('--fingerprint', fingerprint);
  listed('--fingerprint', fingerprint.toLowerCase().replaceAll(':', ''));
  listed('--ca', join(cwd, 'certificate.pem'));
  listed();
  const wrong = programs('--fingerprint', fingerprint.replace(/^../, (byte) => (byte === '00' ? '01' : '00')));
  assert.equal(wrong.status, 1);
  assert.match(wrong.stderr, /the certificate of the monitor at \S+ is not one that is trusted; name it with --ca FILE/);
  const unread = programs('--ca', '/none.pem');
  assert.equal(unread.status, 1);
  assert.match(unread.stderr, /\/none\.pem cannot be read/);
});

test("a certificate stays for the next start, and another's can be named", async (t) => {
  const first = await startEncrypted(t);
  await first.monitor.stop();
  const second = await startEncrypted(t, first.cwd);
  assert.equal(second.fingerprint, first.fingerprint);
  const files = ['--certificate', join(first.cwd, 'certificate.pem'), '--key', join(first.cwd, 'certificate.key')];
  const domain = freshDomain();
  const cwd = scratchFolder(t);
  const third = new Running(t, ['monitor', '--listen', '127.0.0.1:0', '--tls', ...files, '--data', cwd], { domain, cwd });
  await third.line(new RegExp(`fingerprint, .*: ${first.fingerprint}\n`));
  const none = galilean(['monitor', '--listen', '127.0.0.1:0', '--tls', '--certificate', '/none.pem', '--key', '/none.key', '--data', scratchFolder(t)], { domain, cwd });
  assert.equal(none.status, 1);
  assert.match(none.stderr, /^galilean-monitor: \/none\.pem has no certificate in PEM: /);
});

test('a revoked token ends what it has open over TLS, too', async (t) => {
  const { url, ca, cwd } = await startEncrypted(t);
  const { stdout } = galilean(['tokens', 'add', 'anna', '--role', 'operator', '--data', cwd]);
  const headers = { authorization: `Bearer ${stdout.trim()}` };
  const maySteer = async () => JSON.parse((await ask(request, `${url}/api/status`, { ca, headers })).body).may_steer;
  await eventually(async () => (await maySteer()) || delay(50));  // too many questions with it before it is known get 429
  const socket = new WebSocket(`${url.replace('https', 'wss')}/ws`, ['foxglove.websocket.v1'], { ca, headers });
  t.after(() => socket.terminate());
  await within(once(socket, 'open'), () => 'a WebSocket to open');
  const closed = once(socket, 'close');
  assert.equal(galilean(['tokens', 'revoke', 'anna', '--data', cwd]).status, 0);
  const [code] = await within(closed, () => 'a revoked socket to close');
  assert.equal(code, 1008);
});

test('a certificate that is renewed is served from then on, what is open stays, and a damaged one changes nothing', async (t) => {
  const { monitor, url, ca, cwd, fingerprint } = await startEncrypted(t);
  const other = await startEncrypted(t);
  await other.monitor.stop();
  const socket = new WebSocket(`${url.replace('https', 'wss')}/ws`, ['foxglove.websocket.v1'], { ca });
  t.after(() => socket.terminate());
  await within(once(socket, 'open'), () => 'a WebSocket to open');

  const place = (name, content) => {
    writeFileSync(join(cwd, `${name}.new`), content);
    renameSync(join(cwd, `${name}.new`), join(cwd, name));
  };
  place('certificate.pem', 'not a certificate\n');
  await monitor.line(/certificate\.pem has no certificate in PEM: .*; the certificate of before is served still\n/);
  assert.equal((await ask(request, `${url}/api/status`, { ca })).fingerprint, fingerprint);

  for (const name of ['certificate.key', 'certificate.pem']) place(name, readFileSync(join(other.cwd, name)));
  await monitor.line(new RegExp(`a new certificate is served from now on; its SHA-256 fingerprint: ${other.fingerprint}\n`));
  const answer = await ask(request, `${url}/api/status`, { ca: other.ca });
  assert.deepEqual([answer.status, answer.fingerprint], [200, other.fingerprint]);
  await assert.rejects(ask(request, `${url}/api/status`, { ca }), /self.signed|certificate/);
  const answered = once(socket, 'pong');
  socket.ping();
  await within(answered, () => 'an answer on what was open');
});

test('the monitor answers for the names of its certificate, and for no others', async (t) => {
  const { url, ca } = await startEncrypted(t);
  const status = async (host) => (await ask(request, `${url}/api/status`, { ca, headers: { host } })).status;
  assert.equal(await status('localhost:1'), 200);
  assert.equal(await status('evil.example'), 403);
});
