// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import { createServer } from 'node:net';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  childrenOf, eventually, freshDomain, galilean, getJson, processesIn, programs, Running, scratchFolder, startMonitor, startTeam,
} from './tools.mjs';

const status = (url) => getJson(`${url}/api/status`);
const wellOf = (answer) => answer.robots.filter((robot) => !robot.silent);

async function wholeTeam(url) {
  return eventually(async () => {
    const answer = await status(url).catch(() => ({ robots: [] }));
    return wellOf(answer).length === 3 && answer.robots.every((robot) => robot.state !== 'start') && answer;
  });
}

test('another strategy while the team runs', async (t) => {
  const { team, domain, url, link } = await startTeam(t);
  const before = await wholeTeam(url);

  await t.test('a program that is tried scores, goes to nobody, and its simulators end', async (inner) => {
    const headers = { authorization: `Bearer ${new URL(link).hash.replace('#token=', '')}` };
    const program = await getJson(`${url}/api/programs/sit_and_spin.bhdl`);
    // Each robot that throws trash away passes this state, so that its name tells the two programs' runs apart.
    const files = program.files.map(({ path, text }) => ({ path, text: text.replaceAll('"drop_trash"', '"let_trash_go"') }));
    const order = { files, try: { only: true, seeds: 2, duration_s: 120 } };
    const { id } = await getJson(`${url}/api/push`, { method: 'POST', headers, body: JSON.stringify(order) });
    const { pid } = processesIn(domain).find(({ command }) => command.includes('galilean-monitor'));
    let simulators = 0;
    const { state, steps, trial } = await eventually(async () => {
      const push = await getJson(`${url}/api/pushes/${id}`);
      simulators = Math.max(simulators, childrenOf(pid).length);
      return push.state !== 'running' && push;
    });
    assert.equal(state, 'done', JSON.stringify(steps));
    assert.deepEqual(steps.map(({ name, state: ended }) => `${name} ${ended}`), ['check done', 'try done', 'canary left_out', 'rest left_out']);
    assert.equal(trial.runs, 2);
    for (const side of [trial.now, trial.next]) {
      inner.diagnostic(`scores ${side.score.mean} ± ${side.score.spread}, deposits ${side.deposited.mean}`);
      assert.ok(side.score.mean > 0 && side.deposited.mean > 0, JSON.stringify(side));
    }
    const passed = ({ seconds_in_state: states }) => ['drop_trash', 'let_trash_go'].filter((name) => states[name]?.mean > 0);
    assert.deepEqual([passed(trial.now), passed(trial.next)], [['drop_trash'], ['let_trash_go']]);
    assert.deepEqual((await status(url)).robots.map((robot) => robot.program_hash), before.robots.map((robot) => robot.program_hash));
    assert.ok(simulators > 0);
    await eventually(() => childrenOf(pid).length === 0);
  });

  await t.test('a broken program shows its errors and changes nothing', async (inner) => {
    const broken = `${scratchFolder(inner)}/broken.bhdl`;
    writeFileSync(broken, 'include "no_such_file.bhdl"\nstates:\n  state: name: "go"\n    motor_schemas: "nothing" end\n  end\nend\n');
    const refused = galilean(['swap', broken, '--team', '--monitor', url]);
    assert.equal(refused.status, 1);
    assert.match(refused.stdout + refused.stderr, /broken\.bhdl:1:\d+: error: /);
    const after = await status(url);
    assert.deepEqual(after.robots.map((robot) => robot.program_hash), before.robots.map((robot) => robot.program_hash));
  });

  await t.test('sit and spin runs on all three, variables kept, no tick missed', async (inner) => {
    const pushed = galilean(['swap', `${programs}/sit_and_spin.bhdl`, '--team', '--json', '--monitor', url]);
    assert.equal(pushed.status, 0, pushed.stdout + pushed.stderr);
    const { replies } = JSON.parse(pushed.stdout);
    assert.equal(replies.length, 3);
    for (const reply of replies) {
      inner.diagnostic(`${reply.robot}: ${reply.status} ${reply.latency_ms?.toFixed?.(1)} ms after the push, swap tick ${reply.swap_tick_us?.toFixed?.(0)} µs`);
      assert.match(reply.status, /running|confirmed/);
      assert.ok(reply.kept_variables.includes('shaft') && reply.kept_variables.includes('trash'));
    }
    const after = await eventually(async () => {
      const answer = await status(url);
      return answer.robots.every((robot) => robot.program_name === 'sit_and_spin.bhdl') && answer;
    });
    for (const robot of after.robots) assert.ok(robot.tick > 0 && robot.problems.length === 0, JSON.stringify(robot));
  });

  await t.test('stop holds every robot and says so, and resume lets them go on', async () => {
    const stopped = galilean(['stop'], { domain });
    assert.equal(stopped.status, 0, stopped.stdout + stopped.stderr);
    assert.deepEqual(stopped.stdout.trim().split('\n').sort(), ['callisto: stands still', 'ganymede: stands still', 'io: stands still']);
    await eventually(async () => (await status(url)).robots.every((robot) => robot.held));
    assert.equal(galilean(['resume', '--team'], { domain }).status, 0);
    await eventually(async () => (await status(url)).robots.every((robot) => !robot.held));
  });

  await t.test('a robot out of service stays so, whoever resumes, until it is commissioned', async () => {
    const say = (...words) => galilean([...words], { domain }).stdout.trim();
    assert.equal(say('decommission', '--robot', 'io'), 'io: is out of service');
    const robots = await eventually(async () => {
      const answer = await status(url);
      return answer.robots.some((robot) => robot.out_of_service) && answer.robots;
    });
    assert.deepEqual(robots.filter((robot) => robot.out_of_service).map(({ name }) => name), ['io']);
    galilean(['resume', '--robot', 'io'], { domain });
    assert.ok((await status(url)).robots.find(({ name }) => name === 'io').out_of_service);
    assert.equal(say('commission', '--robot', 'io'), 'io: is in service again');
    await eventually(async () => (await status(url)).robots.every((robot) => !robot.out_of_service));
  });

  await t.test('one robot is swapped back, and is shown as drifting', async () => {
    const pushed = galilean(['swap', `${programs}/office_cleanup.bhdl`, '--robot', 'io', '--monitor', url]);
    assert.equal(pushed.status, 0, pushed.stdout + pushed.stderr);
    const answer = await eventually(async () => {
      const now = await status(url);
      return now.robots.some((robot) => robot.drifting) && now;
    });
    assert.deepEqual(answer.robots.filter((robot) => robot.drifting).map((robot) => robot.name), ['io']);
  });

  const { code } = await team.stop();
  assert.equal(code, 0);
});

test('a robot that is killed is silent, stays in the team, and the others run on', async (t) => {
  const { domain, url } = await startTeam(t);
  await wholeTeam(url);
  const callisto = processesIn(domain).find(({ command }) => /galilean-robot .*--name callisto/.test(command));
  process.kill(callisto.pid, 'SIGKILL');
  const answer = await eventually(async () => {
    const now = await status(url);
    return now.robots.find((robot) => robot.name === 'callisto').silent && now;
  });
  assert.equal(answer.robots.length, 3);
  assert.equal(wellOf(answer).length, 2);
  const top = galilean(['top', '--once'], { domain });
  assert.equal(top.status, 0);
  assert.match(top.stdout, /^.*I +io +\w+/m);
  assert.match(top.stdout, /callisto .*silent/);
  const stopped = galilean(['stop'], { domain });
  assert.equal(stopped.status, 1, stopped.stdout + stopped.stderr);
  assert.match(stopped.stdout, /^ganymede: stands still$/m);
  assert.match(stopped.stdout, /^callisto: has sent nothing for \d+ s, so it is not known what it does$/m);
});

test('a second robot of a name says that it would be one, and ends before it moves', async (t) => {
  const { robot, domain, cwd, url, token } = await startMonitor(t);
  const twin = (name) => ['robot', '--name', name, '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none', '--camera', 'shm:none'];
  const second = new Running(t, twin('io'), { domain, cwd });
  assert.deepEqual(await second.exited, { code: 1, signal: null });
  assert.match(second.output, new RegExp(`^galilean-robot: a robot named io lives in DDS domain ${domain} already, and two robots of one name obey and tell as one; end that one, or start this one with another --name or --domain$`, 'm'));
  const alarm = `name: Another robot named io was started in DDS domain ${domain}, and must not be: it ends by itself; start it with another --name.`;
  const io = async () => (await getJson(`${url}/api/status`, { headers: { authorization: `Bearer ${token('operator')}` } })).robots[0];
  await eventually(async () => (await io()).problems.includes(alarm));
  assert.equal((await io()).held, false, 'the first one runs on');

  robot.process.kill('SIGKILL');  // DDS knows it for ten seconds more
  await robot.exited;
  const next = new Running(t, twin('io'), { domain, cwd });
  await next.line(/comm_port/);
  assert.deepEqual(await next.stop(), { code: 0, signal: null });
});

test('a robot that hangs is named by every order to the team, and the others obey', { timeout: 300_000 }, async (t) => {
  const { domain, url } = await startTeam(t);
  await wholeTeam(url);
  const callisto = processesIn(domain).find(({ command }) => /galilean-robot .*--name callisto/.test(command));
  const order = (...words) => {
    const { status: code, stdout, stderr } = galilean(words, { domain });
    return { code, stderr, lines: stdout.trim().split('\n').sort() };
  };
  const unknown = /^callisto: (has sent nothing for \d+ s, so it is not known what it does|sends no state)$/;
  process.kill(callisto.pid, 'SIGSTOP');

  const stopped = order('stop');
  assert.equal(stopped.code, 1);
  assert.match(stopped.lines[0], unknown);
  assert.deepEqual(stopped.lines.slice(1), ['ganymede: stands still', 'io: stands still']);
  for (const words of [['resume', '--team'], ['start', '--team'], ['break', 'grab_trash', '--team'], ['step', '--team'], ['break', '--list'],
    ['break', '--clear', '--team'], ['decommission', '--team'], ['commission', '--team'], ['hold', '--team'], ['hold', '--robot', 'io', '--robot', 'callisto']]) {
    const { code, lines } = order(...words);
    assert.deepEqual([words.join(' '), code], [words.join(' '), 1]);
    assert.match(lines[0], unknown, words.join(' '));
    assert.ok(lines.length > 1, `${words.join(' ')}: ${lines}`);
  }

  const nobody = order('hold', '--robot', 'io', '--robot', 'europa');
  assert.deepEqual(nobody, { code: 1, stderr: '', lines: ['europa: sends no state', 'io: stands still'] });
  assert.match(order('hold', '--robot', 'europa').stderr, /^galilean hold: europa sends no state; check that robots run/);
});

test('camera and serial line unplugged: a robot that resumes by itself says which, and comes back', async (t) => {
  const domain = freshDomain();
  const cwd = scratchFolder(t);
  const sim = new Running(t, ['sim', '--live', '--scenario', 'office', '--robots', '1', '--run', `fault-${domain}`,
    '--autostart', '1', '--fault', 'camera:io@6-10', '--fault', 'serial:io@12-16'], { domain, cwd });
  const { robots } = JSON.parse((await sim.line(/^\{.*"ready".*\}$/m))[0]);
  new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', robots[0].serial, '--camera', robots[0].camera, '--resume-by-itself'], { domain, cwd });
  const monitor = new Running(t, ['monitor', '--listen', '127.0.0.1:0', '--data', cwd], { domain, cwd });
  const [url] = await monitor.line(/http:\/\/127\.0\.0\.1:\d+/);

  const problem = (pattern) => eventually(async () => {
    const io = (await status(url)).robots.find((robot) => robot.name === 'io');
    return io && (pattern ? io.problems.find((text) => pattern.test(text)) : io.problems.length === 0 && io.state !== 'start');
  });
  t.diagnostic(await problem(/^frame_grabber: /));
  await problem(null);
  t.diagnostic(await problem(/^comm_port: /));
  await problem(null);
});

test('a serial line that is plugged in again: the robot says why it is held, and moves when somebody resumes it', { timeout: 180_000 }, async (t) => {
  const domain = freshDomain();
  const cwd = scratchFolder(t);
  const sim = new Running(t, ['sim', '--live', '--scenario', 'office', '--robots', '1', '--run', `held-${domain}`, '--autostart', '1'], { domain, cwd });
  const { robots } = JSON.parse((await sim.line(/^\{.*"ready".*\}$/m))[0]);
  new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', robots[0].serial, '--camera', robots[0].camera], { domain, cwd });
  const monitor = new Running(t, ['monitor', '--listen', '127.0.0.1:0', '--data', cwd], { domain, cwd });
  const [url] = await monitor.line(/http:\/\/127\.0\.0\.1:\d+/);
  const when = (fits) => eventually(async () => {
    const io = (await status(url)).robots.find(({ name }) => name === 'io');
    return io && fits(io) && io;
  });
  const away_m = (a, b) => Math.hypot(a.x_m - b.x_m, a.y_m - b.y_m);
  const started = await when((io) => io.problems.length === 0 && io.state !== 'start');
  await when((io) => away_m(io, started) > 0.1);

  assert.equal(galilean(['sim', 'ctl', 'break', 'io', 'serial_line'], { domain }).status, 0);
  await when((io) => io.held && io.break_reason.startsWith('held: the serial line is gone; '));
  assert.equal(galilean(['sim', 'ctl', 'mend', 'io', 'serial_line'], { domain }).status, 0);
  const back = await when((io) => /^held: the serial line was gone for [\d.]+ s; resume it, or push a bumper\.$/.test(io.break_reason));
  const later = await when((io) => io.tick > back.tick + 60);
  assert.ok(later.held && away_m(later, back) < 0.01, JSON.stringify([back, later]));
  assert.ok(later.problems.includes(later.break_reason), JSON.stringify(later));

  const resumed = galilean(['resume', '--robot', 'io'], { domain });
  assert.equal(resumed.status, 0, resumed.stdout + resumed.stderr);
  await when((io) => !io.held && io.problems.length === 0 && away_m(io, later) > 0.05);
});

test('a camera path that the system refuses: the robot runs on, says what to do, and its motors stand', { timeout: 120_000 }, async (t) => {
  const domain = freshDomain();
  const cwd = scratchFolder(t);
  const sim = new Running(t, ['sim', '--live', '--scenario', 'office', '--robots', '1', '--run', `refused-${domain}`, '--autostart', '0.5'], { domain, cwd });
  const { robots } = JSON.parse((await sim.line(/^\{.*"ready".*\}$/m))[0]);
  const camera = 'x'.repeat(300);
  const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', robots[0].serial, '--camera', camera], { domain, cwd });
  const port = 18900 + Number(domain) % 60;
  new Running(t, ['monitor', '--listen', `127.0.0.1:${port}`, '--data', cwd], { domain, cwd });

  const io = () => status(`http://127.0.0.1:${port}`).then((answer) => answer.robots.find(({ name }) => name === 'io'), () => undefined);
  const started = await eventually(async () => {
    const now = await io();
    return now?.problems.length === 1 && now.state !== 'start' && now;
  });
  const later = await eventually(async () => {
    const now = await io();
    return now.tick > started.tick + 40 && now;
  });
  const what = `frame_grabber: The camera ${camera} cannot be looked for (File name too long): name another one in frame_grabber, or with --camera.`;
  assert.deepEqual(later.problems, [what]);
  assert.ok(robot.output.includes(what), robot.output);
  assert.ok(Math.hypot(later.x_m, later.y_m) < 0.001, `it drove to ${later.x_m} m, ${later.y_m} m`);
  assert.deepEqual(await robot.stop(), { code: 0, signal: null });
});

test('a port that is taken, and an address of another machine, end with one clear line', async (t) => {
  const server = createServer().listen(0, '127.0.0.1');
  t.after(() => server.close());
  await new Promise((resolve) => server.on('listening', resolve));
  for (const [address, words] of [[`127.0.0.1:${server.address().port}`, 'galilean-monitor: another program listens on ADDRESS already; end it, or choose another port with --listen\n'], ['203.0.113.1:8080', 'galilean-monitor: cannot listen on ADDRESS: Cannot assign requested address\n']]) {
    const { status: code, stderr } = galilean(['monitor', '--plain', '--listen', address], { domain: freshDomain(), cwd: scratchFolder(t) });
    assert.equal(code, 1);
    assert.equal(stderr, words.replace('ADDRESS', address));
  }
});

test('DDS that cannot start ends with one clear line', (t) => {
  const { status: code, stderr } = galilean(['top', '--once'], { domain: '999', cwd: scratchFolder(t) });
  assert.equal(code, 1);
  assert.equal(stderr, 'galilean-top: the DDS domain must be from 0 to 232, not 999\n');
});

test('a team is recorded without a display', async (t) => {
  const { domain, url, cwd } = await startTeam(t);
  await wholeTeam(url);
  const recorded = galilean(['record', '--out', `${cwd}/run.mcap`, '--duration', '5'], { domain, cwd });
  assert.equal(recorded.status, / lost \d+ of /.test(recorded.stderr) ? 3 : 0, recorded.stderr);
  const info = JSON.parse(galilean(['log', 'info', `${cwd}/run.mcap`, '--json']).stdout);
  assert.ok(Math.abs(info.duration_seconds - 5) < 1.5, `${info.duration_seconds} s`);
  const topics = info.channels.map((channel) => channel.topic);
  for (const topic of ['/io/state', '/ganymede/variables', '/callisto/program', '/team/objects', '/referee/score'])
    assert.ok(topics.includes(topic), `${topic} is not among ${topics}`);
});
