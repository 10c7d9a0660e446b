// SPDX-License-Identifier: BSD-3-Clause
// `galilean demo` starts a team and ends it, whatever happens to it or to its parts.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { eventually, freePort, freshDomain, galilean, galileanBinary, getJson, processesIn, root, Running, scratchFolder, sharedMemory, startTeam } from './tools.mjs';

const limit = { timeout: 120_000 };

/** The process id of the program that was started with these words, in this domain. */
function pidOf(domain, words) {
  return Number(readdirSync('/proc').find((pid) => {
    try {
      return /^\d+$/.test(pid) && readFileSync(`/proc/${pid}/cmdline`, 'utf8').replaceAll('\0', ' ').includes(words) &&
        readFileSync(`/proc/${pid}/environ`, 'utf8').split('\0').includes(`ROS_DOMAIN_ID=${domain}`);
    } catch { return false; }
  }));
}

const ringsOf = (run) => sharedMemory().filter((name) => name.includes(run));
const runOf = (team) => `demo-${team.process.pid}`;
const lineFolders = (run) => [process.env.XDG_RUNTIME_DIR, tmpdir()].filter(Boolean).map((place) => `${place}/galilean-${run}`);

async function nothingIsLeft(domain, run) {
  await eventually(() => processesIn(domain).length === 0);
  assert.deepEqual(ringsOf(run), []);
  for (const folder of lineFolders(run)) assert.equal(existsSync(folder), false, folder);
}

test('Ctrl-C ends all and leaves nothing behind', limit, async (t) => {
  const { team, domain, url } = await startTeam(t);
  assert.equal(processesIn(domain).length, 6);  // demo, sim, three robots, monitor
  assert.equal(ringsOf(runOf(team)).length, 3);
  await eventually(async () => (await getJson(`${url}/api/status`)).score?.elapsed_s > 0);
  assert.deepEqual(await team.stop('SIGINT'), { code: 0, signal: null });
  for (const robot of ['io', 'ganymede', 'callisto'])
    assert.match(team.output, new RegExp(`^  ${robot} +office_cleanup.*drove [0-9.]+ m, threw away`, 'm'));
  assert.match(team.output, /^ {2}referee +contest running, \d+ of 24 pieces, .* points after [0-9.]+ s, [0-9.]+ s left$/m);
  await nothingIsLeft(domain, runOf(team));
});

test('a second demo in the same domain is refused before it starts a robot, and harms nobody', limit, async (t) => {
  const { team, domain, url } = await startTeam(t, ['--robots', '2']);
  await eventually(async () => (await getJson(`${url}/api/status`)).robots.length === 2);
  const cwd = scratchFolder(t);
  const second = galilean(['demo', '--port', String(await freePort()), '--record', 'second.mcap'], { domain, cwd });
  assert.equal(second.status, 1, second.stdout);
  assert.equal(second.stderr, `galilean-demo: io and ganymede live in DDS domain ${domain} already, and two robots of one name obey and tell ` +
    'as one; end those, or use another domain (--domain or ROS_DOMAIN_ID)\n');
  assert.equal(existsSync(join(cwd, 'second.mcap')), false);
  assert.equal(processesIn(domain).length, 5);  // demo, sim, two robots, monitor
  assert.deepEqual(await team.stop('SIGINT'), { code: 0, signal: null });
});

test('sixteen robots start, and a hundred and one are refused', limit, async (t) => {
  const { url, domain } = await startTeam(t, ['--robots', '16']);
  assert.equal(processesIn(domain).length, 19);
  await eventually(async () => (await getJson(`${url}/api/status`)).robots.filter((robot) => robot.program_hash).length === 16);
  const refused = galilean(['demo', '--robots', '101'], { cwd: scratchFolder(t) });
  assert.equal(refused.status, 2);
  assert.match(refused.stderr, /from 1 to 100 robots, not 101/);
});

test('with no program but those that demo.sh waits for and without a browser the team works, and nothing is left behind', limit, async (t) => {
  const build = process.env.GALILEAN_BUILD ?? `${root}build`;
  const waitedFor = execFileSync('ninja', ['-C', build, '-t', 'query', 'demo_programs'], { encoding: 'utf8' }).match(/bin\/\S+/g);
  assert.ok(!waitedFor.includes('bin/galilean-top'), waitedFor.join());
  const tree = mkdtempSync(join(build, 'demo-only-'));
  t.after(() => rmSync(tree, { recursive: true }));
  for (const part of [...waitedFor, 'share']) cpSync(join(build, part), join(tree, part), { recursive: true });
  const domain = freshDomain();
  const ran = spawnSync(join(tree, 'bin/galilean'), ['demo', '--headless-for', '20', '--port', String(await freePort()), '--seed', '1'],
    { cwd: tree, encoding: 'utf8', env: { ...process.env, ROS_DOMAIN_ID: domain } });
  assert.equal(ran.status, 0, ran.stdout + ran.stderr);
  assert.match(ran.stdout, /callisto +office_cleanup.*drove/);
  assert.deepEqual(processesIn(domain), []);
  const [, pid] = /logs in \.galilean\/run-(\d+);/.exec(ran.stdout);
  assert.deepEqual(ringsOf(`demo-${pid}`), []);
  const early = spawnSync(join(tree, 'bin/galilean'), ['top'], { encoding: 'utf8' });
  assert.equal(early.status, 1);
  assert.match(early.stderr, /galilean-top cannot be started: .*has not been built: demo\.sh builds it while the demo runs/);
});

test('when the demo itself is killed, the others end too', limit, async (t) => {
  const { team, domain } = await startTeam(t);
  await team.stop('SIGKILL');
  await nothingIsLeft(domain, runOf(team));
});

test('a robot that dies is named, and the rest runs on', limit, async (t) => {
  const { team, domain } = await startTeam(t, ['--headless-for', '6']);
  process.kill(pidOf(domain, '--name ganymede'), 'SIGKILL');
  await team.line(/ganymede ended \(killed by signal 9 \(Killed\)\); the others go on\. See \S+ganymede\.log/);
  assert.equal(processesIn(domain).length, 5);
  assert.equal((await team.exited).code, 1);
  assert.match(team.output, /The team did not work/);
  await nothingIsLeft(domain, runOf(team));
});

test('when the simulator dies all ends, and what it left is swept up', limit, async (t) => {
  const { team, domain } = await startTeam(t);
  process.kill(pidOf(domain, 'galilean-sim --live'), 'SIGKILL');
  assert.equal((await team.exited).code, 1);
  assert.match(team.output, /sim ended \(killed by signal 9 \(Killed\)\); without it nothing works/);
  await nothingIsLeft(domain, runOf(team));
});

test('when the monitor is killed the others end by themselves', limit, async (t) => {
  const { team, domain, url } = await startTeam(t);
  await eventually(async () => (await getJson(`${url}/api/status`)).robots.filter((robot) => robot.program_hash).length === 3);
  process.kill(pidOf(domain, 'galilean-monitor'), 'SIGKILL');
  assert.equal((await team.exited).code, 1);
  assert.match(team.output, /monitor ended \(killed by signal 9 \(Killed\)\); without it nothing works/);
  assert.doesNotMatch(team.output, /would not end/);
  await nothingIsLeft(domain, runOf(team));
});

test('a program that is saved while it is watched is taken by every robot', limit, async (t) => {
  const file = `${scratchFolder(t)}/my.bhdl`;
  writeFileSync(file, 'state: name: "first" end\n');
  const { team, url } = await startTeam(t, ['--robots', '2', '--bhdl', file, '--watch']);
  const everyOneIs = (state) => eventually(async () => {
    const { robots } = await getJson(`${url}/api/status`);
    return robots.length === 2 && robots.every((robot) => robot.state === state);
  });
  await everyOneIs('first');
  writeFileSync(file, 'state: name: "second" end\n');
  await everyOneIs('second');
  assert.equal((await team.stop()).code, 0);
});

test('what cannot start says why in a line and leaves nothing', limit, async (t) => {
  const taken = createServer().listen(0, '127.0.0.1');
  t.after(() => taken.close());
  await new Promise((resolve) => taken.on('listening', resolve));
  const cases = [
    [['--port', String(taken.address().port)], /monitor did not start[^]*listens on [0-9.:]+ already/],
    [['--scenario', 'moon'], /sim did not start[^]*moon/],
  ];
  for (const [options, reason] of cases) {
    const domain = freshDomain();
    const demo = new Running(t, ['demo', ...options], { domain, cwd: scratchFolder(t) });
    assert.equal((await demo.exited).code, 1);
    assert.match(demo.output, reason);
    await nothingIsLeft(domain, `demo-${demo.process.pid}`);
  }
});

test('mistakes in expectations are told before anything starts', limit, async (t) => {
  const cwd = scratchFolder(t), domain = freshDomain();
  writeFileSync(`${cwd}/bad.expect`, 'io: nevr it is healthy\n');
  const run = galilean(['demo', '--headless-for', '60', '--expect', 'bad.expect'], { domain, cwd });
  assert.equal(run.status, 1);
  assert.match(run.stderr, /galilean-demo: the expectations cannot be used:\n[^\n]*bad\.expect:1:5: error: /);
  assert.deepEqual(processesIn(domain), []);
  assert.equal(galilean(['demo', '--expect', 'bad.expect'], { domain, cwd }).status, 2);
  assert.equal(galilean(['demo', '--headless-for', '1', '--junit', 'out.xml'], { domain, cwd }).status, 2);
});

test('no file that is there is taken for the recording or the report', limit, async (t) => {
  const cwd = scratchFolder(t), domain = freshDomain();
  const files = { 'run.mcap': 'a recording', 'my.expect': 'every robot: always it is healthy\n', 'my.bhdl': 'include "parts.bhdl"\n', 'parts.bhdl': 'state: name: "first" end\n' };
  for (const [name, text] of Object.entries(files)) writeFileSync(`${cwd}/${name}`, text);
  const judged = ['--headless-for', '60', '--bhdl', 'my.bhdl', '--expect', 'my.expect'];
  const cases = [
    [['--record', 'run.mcap'], /^galilean demo: run\.mcap exists already; choose another name for --record\n/],
    [[...judged, '--junit', './my.expect'], /^galilean demo: \.\/my\.expect is read here and cannot be written/],
    [[...judged, '--junit', 'my.bhdl'], /my\.bhdl is read here and cannot be written/],
    [[...judged, '--junit', './parts.bhdl'], /parts\.bhdl is read here and cannot be written/],
    [[...judged, '--record', 'new', '--junit', './new'], /\.\/new would be written twice/],
  ];
  for (const [options, reason] of cases) {
    const run = galilean(['demo', ...options], { domain, cwd });
    assert.equal(run.status, 2, run.stderr);
    assert.match(run.stderr, reason);
  }
  for (const [name, text] of Object.entries(files)) assert.equal(readFileSync(`${cwd}/${name}`, 'utf8'), text);
  assert.deepEqual(processesIn(domain), []);
});

test('a demo whose recording cannot be made does not run unrecorded', limit, async (t) => {
  const cwd = scratchFolder(t), domain = freshDomain();
  const run = galilean(['demo', '--port', String(await freePort()), '--record', 'none/run.mcap'], { domain, cwd, timeout: 60_000 });
  assert.equal(run.status, 1);
  assert.match(run.stderr, /record did not start \(exit code 1\):\n.*none\/run\.mcap cannot be written/);
  await nothingIsLeft(domain, 'none');
});

/** Makes a folder with a disk of 3 MB at `small`. `behind` is the command, maybe empty, behind which programs find that disk; undefined where none can be made. */
function smallDisk(t) {
  const cwd = mkdtempSync(join(tmpdir(), 'galilean-test-')), folder = join(cwd, 'small');
  let behind;
  t.after(() => {
    if (behind?.length === 0) spawnSync('umount', ['--lazy', folder]);
    rmSync(cwd, { recursive: true, force: true });
  });
  mkdirSync(folder);
  const mount = ['-t', 'tmpfs', '-o', 'size=3M', 'tmpfs', folder];
  const user = process.getuid() === 0 ? [] : ['--user', '--map-root-user'];
  const apart = ['unshare', ...user, '--mount', 'bash', '-c', `mount ${mount.join(' ')} && exec "$@"`, 'bash'];
  if (spawnSync('env', [...apart, 'true']).status === 0) behind = apart;
  // In a chroot nobody can have mounts of their own, but root can mount there.
  else if (spawnSync('mount', mount).status === 0) behind = [];
  return { cwd, behind };
}

test('a demo on a nearly full disk says so at once, ends with 3, and the XML tells it', limit, async (t) => {
  const { cwd, behind } = smallDisk(t), domain = freshDomain();
  if (!behind) return t.skip('needs mount, and unshare for who is not root: no small disk can be made');
  const inSmall = (...command) => spawnSync('env', [...behind, ...command], { cwd, env: { ...process.env, ROS_DOMAIN_ID: domain }, encoding: 'utf8', timeout: 90_000 });
  const demo = ['demo', '--headless-for', '20', '--record', 'small/run.mcap', '--port'];
  const sentence = /galilean-demo: (only \d+ [kM]B are free for 'small\/run\.mcap', less than 500 MB \(--min-free\): nothing is recorded [^\n]*)\n/;

  const plain = inSmall(galileanBinary, ...demo, String(await freePort()));
  assert.equal(plain.status, 3, plain.stdout + plain.stderr);
  assert.match(plain.stdout, /The team worked\./);
  assert.match(plain.stderr, sentence);
  assert.match(plain.stderr, /galilean-demo: messages are missing in small\/run\.mcap; /);

  rmSync(`${cwd}/small/run.mcap`, { force: true });
  writeFileSync(`${cwd}/little.expect`, 'every robot: never state is "moon"\n');
  const judged = inSmall(galileanBinary, ...demo, String(await freePort()), '--expect', 'little.expect', '--junit', 'out.xml');
  assert.equal(judged.status, 3, judged.stdout + judged.stderr);
  assert.match(judged.stderr, sentence);
  assert.match(readFileSync(`${cwd}/out.xml`, 'utf8'), /name="the recording">\s*<error message="only \d+ [kM]B are free for /);
  await nothingIsLeft(domain, 'none');
});

test('the XML tells of a run that came to nothing', limit, async (t) => {
  const cwd = scratchFolder(t), domain = freshDomain();
  const xml = () => readFileSync(`${cwd}/out.xml`, 'utf8');
  const options = (...more) => ['demo', '--headless-for', '6', '--expect', 'office', '--junit', 'out.xml', ...more];

  assert.equal(galilean(options('--scenario', 'moon'), { domain, cwd }).status, 1);
  assert.match(xml(), /<testsuites tests="1" failures="0" errors="1">[^]*<error message="sim did not start [^"]*moon/);

  writeFileSync(`${cwd}/bad.expect`, 'io: nevr it is healthy\n');
  assert.equal(galilean(options('--expect', 'bad.expect'), { domain, cwd }).status, 1);
  assert.match(xml(), /file="bad\.expect" line="1"[^]*<error message="expected a claim, not/);

  const cutShort = new Running(t, options('--port', String(await freePort())), { domain, cwd });
  await cutShort.line(/http:\/\/127/);
  assert.match(xml(), /<error message="the run has not come to its end"/);
  assert.equal((await cutShort.stop('SIGTERM')).code, 1);
  assert.match(xml(), /<error message="interrupted before its time was over"/);

  writeFileSync(`${cwd}/little.expect`, 'io: never state is "moon"\n');
  const bereft = new Running(t, ['demo', '--headless-for', '6', '--expect', 'little.expect', '--junit', 'out.xml', '--port', String(await freePort())], { domain, cwd });
  await bereft.line(/http:\/\/127/);
  process.kill(pidOf(domain, '--name ganymede'), 'SIGKILL');
  assert.equal((await bereft.exited).code, 1);
  assert.match(xml(), /<testcase classname="[^"]*" name="the run">\s*<error message="ganymede ended"/);

  const stuck = new Running(t, options('--port', String(await freePort())), { domain, cwd });
  await stuck.line(/http:\/\/127/);
  process.kill(pidOf(domain, '--name io'), 'SIGSTOP');
  assert.equal((await stuck.exited).code, 1);
  assert.match(xml(), /<testsuites tests="1" failures="0" errors="1">[^]*<error message="io would not end and was killed/);
  await nothingIsLeft(domain, runOf(stuck));
});

test('a run that does not do what is expected of it fails', limit, async (t) => {
  const cwd = scratchFolder(t), domain = freshDomain();
  writeFileSync(`${cwd}/moon.expect`, 'every robot: never state is "start"\n');
  const run = galilean(['demo', '--port', String(await freePort()), '--headless-for', '8', '--expect', 'moon.expect'], { domain, cwd, timeout: 90_000 });
  assert.equal(run.status, 1, run.stdout + run.stderr);
  assert.match(run.stdout, /never state is "start"/);
  await nothingIsLeft(domain, 'none');
});

test('a program that no robot can run is told of before anything starts', limit, async (t) => {
  const cwd = scratchFolder(t), domain = freshDomain();
  writeFileSync(`${cwd}/copy.bhdl`, 'include "lacking.bhdl"\n');
  for (const [program, sentence] of [['nosuch', /no program 'nosuch': expected a \.bhdl file, or the name of a program that ships/], ['copy.bhdl', /\ncopy\.bhdl:1:9: error: cannot read 'lacking\.bhdl'/]]) {
    const run = galilean(['demo', '--robots', '1', '--bhdl', program], { domain, cwd });
    assert.equal(run.status, 1);
    assert.match(run.stderr, sentence);
    assert.equal(run.stdout, '');
    assert.deepEqual(processesIn(domain), []);
  }
});

test('when the last robot has ended the demo ends', limit, async (t) => {
  const { team, domain } = await startTeam(t, ['--robots', '1']);
  await team.line(/^ {2}io runs office_cleanup in scenario office/m);
  process.kill(pidOf(domain, '--name io'), 'SIGKILL');
  assert.equal((await team.exited).code, 1);
  assert.match(team.output, /io ended \(killed by signal 9 \(Killed\)\); no robot is left, so that the demo ends/);
  await nothingIsLeft(domain, runOf(team));
});
