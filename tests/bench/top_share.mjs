// SPDX-License-Identifier: BSD-3-Clause
// What share of a core `galilean top` takes beside a team, by its threads, and procps' top beside it:
//   node tests/bench/top_share.mjs [ROBOTS=30] [SECONDS=30] [ROUNDS=3]
// Both draw ten times a second on a terminal (tmux's) of 120 × 36 cells. GALILEAN_TOPS=FILE,FILE names
// other builds of galilean-top, which take turns beside one team.
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { atTheEnd, bench, domain, freePort, line, median, output, peer, program, scratchFolder, start } from './server/tools.mjs';

const [robots = 30, seconds = 30, rounds = 3] = process.argv.slice(2).map(Number);
const [SETTLE_S, COLUMNS, ROWS] = [10, 120, 36];
const tops = (process.env.GALILEAN_TOPS ?? program('galilean-top')).split(',');
const sleep = (s) => new Promise((resolve) => setTimeout(resolve, s * 1000));
const ticks_a_s = Number(output('getconf', ['CLK_TCK']));

/** Processor seconds that each kind of thread has used: the main thread is where messages are decoded and drawn. */
function used(pid) {
  const threads = {};
  for (const task of readdirSync(`/proc/${pid}/task`)) {
    const [, name, rest] = /^\d+ \((.*)\) (.*)$/s.exec(readFileSync(`/proc/${pid}/task/${task}/stat`, 'utf8'));
    const [user, system] = rest.split(' ').slice(11, 13).map(Number);
    const kind = task === String(pid) ? 'main' : name.startsWith('recv') ? 'receives' : 'other';
    threads[kind] = (threads[kind] ?? 0) + (user + system) / ticks_a_s;
  }
  return threads;
}

/** The process that a terminal of its own runs. */
function onTerminal(name, command) {
  const server = ['-L', `galilean-bench-${process.pid}-${name}`];
  const tmux = (...words) => output('tmux', [...server, ...words], { env: { ...process.env, ROS_DOMAIN_ID: domain, LC_ALL: 'C.UTF-8' } });
  tmux('-f', '/dev/null', 'new-session', '-d', '-x', String(COLUMNS), '-y', String(ROWS), `exec ${command}`);
  return { pid: Number(tmux('display-message', '-p', '#{pane_pid}')), screen: () => tmux('capture-pane', '-p'), end: () => void spawnSync('tmux', [...server, 'kill-server'], { stdio: 'ignore' }) };
}

await bench(async () => {
  const cwd = scratchFolder(), port = await freePort();
  const [tmux, procps] = [peer('tmux', 'TMUX_PROGRAM', 'tmux'), peer('top', 'PROCPS_TOP', 'procps')];
  if (tmux !== 'tmux') throw new Error('tmux must be in the path');
  const demo = start(program('galilean-demo'), ['--robots', String(robots), '--port', String(port)], { cwd, env: { XDG_STATE_HOME: cwd } });
  await line(demo, /http:\/\//);

  /** The shares of a core, of each kind of thread, and in all. */
  async function shares(name, command) {
    const terminal = onTerminal(name, command);
    atTheEnd(terminal.end);
    await sleep(SETTLE_S);
    const [before, began] = [used(terminal.pid), performance.now()];
    await sleep(seconds);
    const [after, lasted_s] = [used(terminal.pid), (performance.now() - began) / 1000];
    const screen = terminal.screen();
    terminal.end();
    const share = Object.fromEntries(Object.keys(after).map((kind) => [kind, 100 * (after[kind] - (before[kind] ?? 0)) / lasted_s]));
    return { share: { ...share, all: Object.values(share).reduce((a, b) => a + b, 0) }, screen };
  }
  const measured = Object.fromEntries([...tops, procps].map((name) => [name, []]));
  for (let round = 0; round < rounds; round += 1)
    for (const [i, name] of [...tops, procps].entries()) {
      const { share, screen } = await shares(`${round}-${i}`, name === procps ? `${procps} -d 0.1` : name);
      if (name !== procps && !screen.includes(`${robots} robots`)) throw new Error(`galilean top does not show ${robots} robots:\n${screen}`);
      measured[name].push(share);
    }
  for (const [name, all] of Object.entries(measured)) {
    const kinds = Object.keys(all[0]).map((kind) => `${kind} ${median(all.map((share) => share[kind])).toFixed(1)} %`);
    console.log(`${name}: ${kinds.join(', ')} of a core (in all ${all.map((share) => share.all.toFixed(1)).join(', ')})`);
  }
});
