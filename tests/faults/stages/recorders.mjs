// SPDX-License-Identifier: BSD-3-Clause
// Recorders of somebody who talks, in a DDS domain of their own, until their disk is full or they are killed.
import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, rmSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { scratchFolder } from '../../end_to_end/tools.mjs';
import { program, start, testTool } from '../../logs/tools.mjs';
import { PATIENCE_MS, within } from '../../tools/patience.mjs';
import { until } from '../table.mjs';
import { closeOf, endChild } from './children.mjs';
import { onSmallDisk } from './namespaces.mjs';

/** Recorders of half a megabyte a second take less until their disk is full. */
const FULL_WITHIN_MS = 30_000;
const RECORDERS = 5, RECORDERS_DISK_kB = 1500, KILLED_AT_BYTES = 1_000_000;

/** A recorder on a disk of its own, until that is full, and what can be read of the file then. */
export function recordUntilFull(scope, domain) {
  const cwd = scratchFolder(scope), disk = join(cwd, 'disk');
  mkdirSync(disk);
  const script = `"$0" --out disk/run.mcap --domain ${domain} --picture-rate 0 --min-free 0 --compression none >&2
    echo "{\\"code\\": $?, \\"ended_ns\\": \\"$(date +%s%N)\\"}"; "$1" info disk/run.mcap --json`;
  const [command, ...args] = onSmallDisk(disk, RECORDERS_DISK_kB, ['bash', '-c', script, program('galilean-record'), program('galilean-log')]);
  // A group of its own, so that the recorder ends with the shell that waits for it.
  const child = spawn(command, args, { cwd, detached: true });
  const closed = closeOf(child);
  const killAll = () => {
    try {
      process.kill(-child.pid, 'SIGKILL');
    } catch { /* they have ended */ }
  };
  scope.after(killAll);
  const said = { stdout: '', stderr: '' };
  for (const stream of ['stdout', 'stderr']) child[stream].setEncoding('utf8').on('data', (text) => { said[stream] += text; });
  return within(closed.then(() => said), () => `a recorder's disk to be full: ${said.stderr}`, FULL_WITHIN_MS).finally(() => {
    killAll();
    rmSync(cwd, { recursive: true, force: true });
  });
}

/** A recorder that is killed while it writes, and how many seconds of its recording are lost at the end. */
export async function recordUntilKilled(scope, domain) {
  const cwd = scratchFolder(scope), file = join(cwd, 'run.mcap');
  const recorder = start(program('galilean-record'), ['--out', file, '--domain', domain, '--picture-rate', '0', '--min-free', '0']);
  const closed = closeOf(recorder);
  scope.after(() => endChild(recorder, closed, () => recorder.kill('SIGKILL')));
  await until(() => statSync(file, { throwIfNoEntry: false })?.size > KILLED_AT_BYTES, 'the recorder to write', 30);
  recorder.kill('SIGKILL');
  const killed_ms = Date.now();
  await recorder.ended;
  const { stdout, stderr } = spawnSync(program('galilean-log'), ['info', file, '--json'], { encoding: 'utf8', timeout: PATIENCE_MS });
  rmSync(file);
  if (!stdout) throw new Error(`the recording cannot be read: ${stderr}`);
  return (killed_ms - Number(JSON.parse(stdout).end_ns) / 1e6) / 1000;
}

/** How many seconds of a recording are lost at its end. */
export function lostAtTheEnd({ stdout, stderr }) {
  const end = stdout.indexOf('\n');
  const { code, ended_ns } = JSON.parse(stdout.slice(0, end));
  if (code !== 1) throw new Error(`the recorder ended with ${code}: ${stderr}`);
  if (!/cannot be written/.test(stderr)) throw new Error(`the recorder did not say why it ended: ${stderr}`);
  const info = JSON.parse(stdout.slice(end));
  return (Number(ended_ns) - Number(info.end_ns)) / 1e9;
}

const talk = (stage) => {
  const talker = start(testTool('wire_talker'), ['io', stage.recorders_domain]);
  const closed = closeOf(talker);
  stage.scope.after(stage.endTalk = () => endChild(talker, closed, () => talker.kill('SIGKILL')));
};
export const endTalk = (stage) => stage.endTalk();
export const recordings = (record) => (stage) => {
  talk(stage);
  return Promise.all(Array.from({ length: RECORDERS }, () => record(stage.scope, stage.recorders_domain)));
};
