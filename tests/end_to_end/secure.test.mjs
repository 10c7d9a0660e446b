// SPDX-License-Identifier: BSD-3-Clause
// A team with keys: what members do, and that strangers, and members beyond their role, get nothing.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { places } from './help.mjs';
import { eventually, freshDomain, galilean, galileanBinary, programs, Running, scratchFolder, startTeam } from './tools.mjs';

/** How long a stranger listens: a member has heard its first message after a fraction of that. */
const LISTENS = '5s';
/** What revoking promises. */
const PARTED_MS = 10_000;

const keys = (folder, ...words) => galilean(['team', 'keys', ...words, '--team', folder]);

/** A team's folder with these members, `{ name: role }`; `of(name)` is a member's folder. */
function makeTeam(t, members) {
  const folder = join(scratchFolder(t), 'team');
  const made = keys(folder, 'init');
  assert.equal(made.status, 0, made.stderr);
  const of = (name) => join(folder, 'members', name);
  for (const [name, role] of Object.entries(members)) {
    const { status, stdout, stderr } = keys(folder, 'add', name, '--role', role);
    assert.equal(status, 0, stderr);
    assert.equal(stdout, `${of(name)}\n`);
  }
  return { folder, of };
}

/** A robot that has neither board nor camera, in a team of its own. */
async function startSecured(t, members = {}) {
  const team = makeTeam(t, { io: 'robot', boss: 'monitor', ...members });
  const domain = freshDomain();
  const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none',
    '--camera', 'shm:none', '--secure', team.of('io')], { domain, cwd: scratchFolder(t) });
  await robot.line(/comm_port/);
  return { ...team, domain, robot };
}

/** What came of waiting for the robot's state; status 0: it was heard. */
const listen = (domain, folder, timeout = LISTENS) =>
  galilean(['wait', 'io/state.tick > 0', '--timeout', timeout, ...(folder ? ['--secure', folder] : [])], { domain });

function assertHears(domain, folder) {
  const { status, stdout, stderr } = listen(domain, folder, '60s');
  assert.equal(status, 0, stdout + stderr);
}

function assertHearsNothing(domain, folder) {
  const { status, stdout, stderr } = listen(domain, folder);
  assert.equal(status, 1, stdout + stderr);
  return stderr;
}

/** What the command says that makes the robot stand still. */
function hold(domain, env = {}) {
  const { stdout, stderr } = galilean(['hold', '--robot', 'io'], { domain, env });
  return stdout + stderr;
}
const OBEYED = /^io: stands still/m;

/** What a program has told of DDS Security that fits, a line each. */
const told = ({ output }, pattern) => output.split('\n').filter((line) => line.startsWith('galilean: DDS Security: ') && pattern.test(line));

/** The XML in a document that is signed as S/MIME. */
const textIn = (file) => readFileSync(file, 'utf8').replaceAll('\r\n', '\n').match(/<\?xml[\s\S]*<\/dds>\n/)[0];

/** Signs a document as the authority would, with another's key. */
function sign(file, text, certificate, key) {
  writeFileSync(`${file}.xml`, text);
  execFileSync('openssl', ['smime', '-sign', '-text', '-in', `${file}.xml`, '-out', file, '-signer', certificate, '-inkey', key]);
}

test('every program that joins a domain takes keys', () => {
  const joining = places().filter(({ options }) => options.includes('--domain'));
  assert.ok(joining.length > 15);
  assert.deepEqual(joining.filter(({ options }) => !options.includes('--secure')).map(({ path }) => path.join(' ')), []);
});

test('members hear and command one another; GALILEAN_SECURE is as good as --secure', async (t) => {
  const { domain, of } = await startSecured(t);
  assertHears(domain, of('boss'));
  const env = { GALILEAN_SECURE: of('boss') };
  assert.match(hold(domain, env), OBEYED);
  const topics = galilean(['list'], { domain, env });
  assert.match(topics.stdout, /\/io\/state/);
});

test('a whole demo runs with keys, and no role lacks what its programs ask for', async (t) => {
  const { folder, of } = makeTeam(t, { io: 'robot', ganymede: 'robot', demo: 'viewer', sim: 'simulator', monitor: 'monitor', record: 'recorder', boss: 'monitor' });
  const { team, domain, cwd } = await startTeam(t, ['--robots', '2', '--record', 'run.mcap', '--secure', folder]);
  for (const wanted of ['io/state.tick > 20', 'ganymede/state.tick > 20']) {
    const { status, stdout, stderr } = galilean(['wait', wanted, '--timeout', '60s', '--secure', of('boss')], { domain });
    assert.equal(status, 0, stdout + stderr);
  }
  await eventually(() => {
    const { stdout } = galilean(['list', '--secure', of('boss')], { domain });
    return ['/io/program', '/referee/score', '/simulation/state', '/team/map'].every((topic) => stdout.includes(topic));
  });
  assertHearsNothing(domain);
  await team.stop();

  const runs = join(cwd, '.galilean');
  const logs = readdirSync(runs, { recursive: true }).filter((name) => name.endsWith('.log')).map((name) => readFileSync(join(runs, name), 'utf8'));
  assert.ok(logs.length >= 5, `logs of simulator, robots, monitor and recorder: ${logs.length}`);
  for (const log of [...logs, team.output]) assert.doesNotMatch(log, /does not let/);
});

test('who has no keys, or those of another team, hears nothing and moves nothing', async (t) => {
  const { domain, robot, of } = await startSecured(t);
  assertHearsNothing(domain);
  assertHearsNothing(domain);
  assert.doesNotMatch(hold(domain), OBEYED);
  await robot.line(/ has no keys, so that it neither hears this team nor is heard; start it with --secure\n/);

  const foreign = makeTeam(t, { boss: 'monitor' });
  assert.match(assertHearsNothing(domain, foreign.of('boss')), /not from this team's identity CA; ask for keys of this team \(.*CN=io/);
  assert.doesNotMatch(hold(domain, { GALILEAN_SECURE: foreign.of('boss') }), OBEYED);
  await robot.line(/not from this team's identity CA; ask for keys of this team \(.*CN=boss/);
  assertHears(domain, of('boss'));

  // Each was there with two programs or more.
  const unsecured = told(robot, /has no keys/);
  assert.ok(unsecured.length <= 2, `two names at most: ${unsecured}`);
  assert.equal(told(robot, /identity CA/).length, 1, robot.output);
  assert.equal(told(robot, /./).length, unsecured.length + 1, robot.output);
});

test('a team without keys does not hear a member either', async (t) => {
  const { of } = makeTeam(t, { boss: 'monitor' });
  const domain = freshDomain();
  const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none', '--camera', 'shm:none'],
    { domain, cwd: scratchFolder(t) });
  await robot.line(/comm_port/);
  assertHears(domain);
  assertHearsNothing(domain, of('boss'));
});

test('keys that have expired are refused, and renewed ones are not', async (t) => {
  const { folder, domain, of } = await startSecured(t);
  assert.equal(keys(folder, 'add', 'late', '--role', 'viewer', '--expires', '1s').status, 0);
  await delay(2500);
  assert.match(assertHearsNothing(domain, of('late')), /late.*has expired; 'galilean team keys renew' renews it/);
  assert.match(keys(folder, 'list').stdout, /^late {2}viewer {2}expired/m);
  assert.equal(keys(folder, 'renew', 'late').status, 0);
  assertHears(domain, of('late'));
});

test('a robot whose keys expire goes on, and the team parts with it', async (t) => {
  const { folder, of } = makeTeam(t, { boss: 'monitor' });
  assert.equal(keys(folder, 'add', 'io', '--role', 'robot', '--expires', '15s').status, 0);
  const domain = freshDomain();
  const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none',
    '--camera', 'shm:none', '--secure', of('io')], { domain, cwd: scratchFolder(t) });
  await robot.line(/comm_port/);
  assertHears(domain, of('boss'));
  await robot.line(/the keys of this program have expired/);
  assert.match(assertHearsNothing(domain, of('boss')), /has expired; 'galilean team keys renew' renews it/);
  assert.equal(robot.process.exitCode, null);
  assert.deepEqual(await robot.stop(), { code: 0, signal: null });
});

test('a grant that a member signs itself opens nothing', async (t) => {
  const { domain, robot, of } = await startSecured(t, { eve: 'viewer' });
  const eve = of('eve');
  const grant = textIn(join(eve, 'permissions.p7s')).replaceAll(/<topic>.*<\/topic>/g, '<topic>*</topic>');
  const governance = textIn(join(eve, 'governance.p7s'));

  // By its own certificate, which the identity authority has signed: with one authority for both this would do.
  for (const [file, text] of [['permissions.p7s', grant], ['governance.p7s', governance]])
    sign(join(eve, file), text, join(eve, 'identity.pem'), join(eve, 'identity.key'));
  assert.match(assertHearsNothing(domain, eve), /not signed by this team's permissions CA/);
  cpSync(join(eve, 'identity_ca.pem'), join(eve, 'permissions_ca.pem'));
  assertHearsNothing(domain, eve);

  // By an authority of its own.
  const own = makeTeam(t, {});
  for (const [file, text] of [['permissions.p7s', grant], ['governance.p7s', governance]])
    sign(join(eve, file), text, join(own.folder, 'permissions_ca.pem'), join(own.folder, 'permissions_ca.key'));
  cpSync(join(own.folder, 'permissions_ca.pem'), join(eve, 'permissions_ca.pem'));
  assertHearsNothing(domain, eve);
  await robot.line(/the grant is not signed by this team's permissions CA/);
  assertHears(domain, of('boss'));
});

test('a viewer watches and steers nothing', async (t) => {
  const { domain, of } = await startSecured(t, { anna: 'viewer' });
  assertHears(domain, of('anna'));
  const said = hold(domain, { GALILEAN_SECURE: of('anna') });
  assert.doesNotMatch(said, OBEYED);
  assert.equal(said.match(/does not let this program (write|use topic) rt\/team\/command/g)?.length, 1, said);
  assert.match(hold(domain, { GALILEAN_SECURE: of('boss') }), OBEYED);
});

test('a viewer whose program was changed to obey no role gives no order, and is told', async (t) => {
  const { domain, robot, of } = await startSecured(t, { eve: 'viewer' });
  const folder = scratchFolder(t);
  const changed = (name, ...args) => {
    cpSync(join(dirname(galileanBinary), name), join(folder, name));
    const { stdout, stderr } = spawnSync(join(folder, name), args,
      { env: { ...process.env, ROS_DOMAIN_ID: domain, GALILEAN_SECURE: of('eve') }, encoding: 'utf8', timeout: 60_000 });
    return stdout + stderr;
  };
  cpSync(join(dirname(galileanBinary), '../tests/libdisobedient.so'), join(folder, 'libgalilean_authentication.so'));
  const said = changed('galilean-command', 'hold', '--robot', 'io');
  assert.doesNotMatch(said, OBEYED);
  assert.doesNotMatch(said, /does not let this program/, 'it is no changed program');
  await robot.line(/DDS Security: the role of the member [0-9a-f]{12} does not let it write rt\/team\/command\n/);
  assert.equal(told(robot, /write rt\/team\/command/).length, 1, robot.output);
  assert.match(hold(domain, { GALILEAN_SECURE: of('boss') }), OBEYED);
});

test('a robot writes topics of its own name alone', async (t) => {
  const { folder, of } = makeTeam(t, { io: 'robot', boss: 'monitor' });
  const domain = freshDomain();
  const robot = new Running(t, ['robot', '--name', 'europa', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none',
    '--camera', 'shm:none', '--secure', of('io')], { domain, cwd: scratchFolder(t) });
  await robot.line(/does not let this program (write|use topic) rt\/europa\//);
  const { status } = galilean(['wait', 'europa/state.tick > 0', '--timeout', LISTENS, '--secure', of('boss')], { domain });
  assert.equal(status, 1);

  const nobody = galilean(['wait', 'io/state.tick > 0', '--timeout', '1s', '--secure', folder], { domain });
  assert.equal(nobody.status, 1);
  assert.match(nobody.stderr, /has no member .*galilean team keys add/);
});

test('a revoked member is out within ten seconds, and stays out with its old files', async (t) => {
  const { folder, domain, robot, of } = await startSecured(t, { eve: 'viewer' });
  const old = join(scratchFolder(t), 'old');
  cpSync(of('eve'), old, { recursive: true });
  const eve = new Running(t, ['echo', 'io/state', '--field', 'tick', '--secure', old], { domain });
  await eve.line(/\d+\n/);

  assert.equal(keys(folder, 'revoke', 'eve').status, 0);
  await delay(PARTED_MS);
  const heard = eve.output.length;
  assertHears(domain, of('boss'));
  await delay(2000);
  assert.equal(eve.output.length, heard, `it still hears:\n${eve.output.slice(heard)}`);

  assertHearsNothing(domain, old);
  await robot.line(/the member is revoked/);
  assert.equal(told(robot, /revoked/).length, 1, robot.output);
  assert.match(assertHearsNothing(domain, of('eve')), /the certificate is revoked/);
  assert.match(keys(folder, 'list').stdout, /^eve {2}viewer {2}revoked/m);

  // Another one of that name is not the old one.
  assert.equal(keys(folder, 'add', 'eve', '--role', 'viewer').status, 0);
  assertHears(domain, of('eve'));
  assertHearsNothing(domain, old);
});

test('a list of revoked members that is gone revokes nobody and lets nobody back', async (t) => {
  const { folder, domain, robot, of } = await startSecured(t, { eve: 'viewer' });
  const old = join(scratchFolder(t), 'old');
  cpSync(of('eve'), old, { recursive: true });
  assert.equal(keys(folder, 'revoke', 'eve').status, 0);
  const list = readFileSync(join(of('io'), 'revoked.crl'));
  await delay(2500);  // the robot has read the list
  assertHearsNothing(domain, old);

  rmSync(join(of('io'), 'revoked.crl'));
  await robot.line(/revoked\.crl is not a list of revoked members/);
  assertHearsNothing(domain, old);
  writeFileSync(join(of('io'), 'revoked.crl'), list);
  assertHears(domain, of('boss'));
});
