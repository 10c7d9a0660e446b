// SPDX-License-Identifier: BSD-3-Clause
// What the benchmarks of recordings share: what processes take of the machine, and a team that is recorded.
import { spawn } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { freePort, line, output, program, start } from '../server/tools.mjs';

/** What a recorder, and a verb of `galilean log`, may take at most, however long a recording is. */
export const MOST_MiB = 100;
const LOOK_EACH_MS = 5;
const ticks_a_s = Number(output('getconf', ['CLK_TCK']));

export const sleep = (s) => new Promise((resolve) => setTimeout(resolve, s * 1000));
export const share = (part, of) => `${(part / of).toFixed(2)} of ${of}`;

function read(path) {
  try {
    return readFileSync(path, 'utf8');
  } catch {
    return ''; // it has ended
  }
}

/** Processor seconds that a process has used. */
export function processorSeconds(pid) {
  const [user, system] = read(`/proc/${pid}/stat`).replace(/^.*\) /s, '').split(' ').slice(11, 13).map(Number);
  return (user + system) / ticks_a_s;
}

/** The most memory that a process has had so far, or 0 if it has ended. */
export const peakMiB = (pid) => Number(/^VmHWM:\s+(\d+) kB$/m.exec(read(`/proc/${pid}/status`))?.[1] ?? 0) / 1024;

function childrenOf(pid) {
  try {
    return readdirSync(`/proc/${pid}/task`).flatMap((task) => read(`/proc/${pid}/task/${task}/children`).split(' ').filter(Boolean));
  } catch {
    return [];
  }
}

/**
 * Runs `galilean` to its end. `peak_MiB` is that of the process, or of one that it started, which had the most. Throws
 * where it did not do what it was told; what it found wrong with a recording is no fault here.
 */
export async function galilean(args, options = {}) {
  const child = spawn(program('galilean'), args, { stdio: ['ignore', options.keep ? 'pipe' : 'ignore', 'pipe'], cwd: options.cwd });
  let [text, complaints, peak_MiB] = ['', '', 0];
  child.stdout?.on('data', (data) => { text += data; });
  child.stderr.on('data', (data) => { complaints += data; });
  const look = () => {
    for (const pid of [child.pid, ...childrenOf(child.pid)]) peak_MiB = Math.max(peak_MiB, peakMiB(pid));
  };
  const looking = setInterval(look, LOOK_EACH_MS);
  const began = performance.now();
  const status = await new Promise((resolve, reject) => child.on('error', reject).on('close', (code, signal) => resolve(code ?? signal)));
  clearInterval(looking);
  const took_s = (performance.now() - began) / 1000;
  if (![0, 1, 3].includes(status) || (status === 1 && !options.mayFail)) throw new Error(`galilean ${args.join(' ')} ended with ${status}:\n${complaints}`);
  return { status, took_s, peak_MiB, text };
}

export const infoOf = async (file) => JSON.parse((await galilean(['log', 'info', file, '--json'], { keep: true })).text);

/** A team of the demo, in `cwd`, that ends with this program or by its `end()`. */
export async function startTeam({ robots, cwd }) {
  const demo = start(program('galilean-demo'), ['--robots', String(robots), '--port', String(await freePort())], { cwd, env: { XDG_STATE_HOME: cwd } });
  await line(demo, /http:\/\//);
  return demo;
}

/** A recorder that has begun its file. What it says at its end does not belong to the figures. */
export async function startRecorder({ file, options = [] }) {
  const recorder = start(program('galilean-record'), ['--out', file, ...options], { stdio: ['ignore', 'ignore', 'ignore'] });
  for (let looks = 0; !existsSync(file); ++looks) {
    if (looks > 1000 || recorder.exitCode !== null) throw new Error(`galilean record does not begin ${file}`);
    await sleep(0.02);
  }
  return recorder;
}
