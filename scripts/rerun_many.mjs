// SPDX-License-Identifier: BSD-3-Clause
// Records teams of separate processes under load, loss and jitter, and runs each recording again:
//   node scripts/rerun_many.mjs [--recordings 200] [--seconds 8] [--robots 2] [--loss 50] [--builds build,build/clang] [--at-once 1]
// `loss` is how many of a thousand packets DDS drops. Robots are stopped now and then for some milliseconds. A process
// that computes takes what time there is. Teams are of the first build; all builds run the recordings again, and the
// slowest run of each is told beside the 50 × real time that are wanted. So many teams drive at a time as --at-once
// says. Ends with 1 if a bit differs or a recording cannot be told of. What differs is kept, and its name is printed.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { parseArgs } from 'node:util';
import { processesIn } from '../tests/end_to_end/tools.mjs';
import { freshDomain } from '../tests/tools/domain.mjs';
import { freePort } from '../tests/tools/port.mjs';

const root = new URL('..', import.meta.url).pathname;
const { values: asked } = parseArgs({
  options: {
    recordings: { type: 'string', default: '200' }, seconds: { type: 'string', default: '8' },
    robots: { type: 'string', default: '2' }, loss: { type: 'string', default: '50' },
    builds: { type: 'string', default: 'build' }, 'at-once': { type: 'string', default: '1' },
  },
});
const builds = asked.builds.split(',');
/** How many times as fast as it was a run is wanted to be. */
const WANTED_X = 50;
const binary = (build) => join(root, build, 'bin/galilean');
const folder = mkdtempSync(join(tmpdir(), 'galilean-rerun-'));
const lossy = `<Domain id="any"><Internal><Test><XmitLossiness>${asked.loss}</XmitLossiness></Test></Internal></Domain>`;

const start = (domain, args) => {
  const child = spawn(binary(builds[0]), args, {
    cwd: folder, stdio: 'ignore', env: { ...process.env, ROS_DOMAIN_ID: domain, CYCLONEDDS_URI: lossy, XDG_STATE_HOME: folder },
  });
  child.ended = new Promise((resolve) => child.on('close', resolve));
  return child;
};
const stop = (child) => (child.kill('SIGINT'), child.ended);
const robotsIn = (domain) => processesIn(domain).filter(({ command }) => /galilean-robot /.test(command));

/** Stops a robot for up to 150 ms, again and again. */
async function shake(domain, until) {
  while (Date.now() < until) {
    for (const { pid } of robotsIn(domain)) {
      try {
        process.kill(pid, 'SIGSTOP');
        await sleep(Math.random() * 150);
        process.kill(pid, 'SIGCONT');
      } catch { /* it has ended */ }
    }
    await sleep(Math.random() * 1000);
  }
}

async function record(number, domain) {
  const file = join(folder, `${number}.mcap`);
  const recorder = start(domain, ['record', '--out', file, '--inputs', '--pictures', 'none']);
  while (!existsSync(file)) await sleep(20);
  const team = start(domain, ['demo', '--robots', asked.robots, '--seed', String(number), '--port', String(await freePort())]);
  while (robotsIn(domain).length < Number(asked.robots)) await sleep(50);
  await shake(domain, Date.now() + 1000 * Number(asked.seconds));
  await stop(team);
  await stop(recorder);
  return file;
}

const load = spawn('nice', ['sh', '-c', 'while :; do :; done'], { stdio: 'ignore' });
process.on('exit', () => load.kill());
const sums = Object.fromEntries(builds.map((build) => [build, { runs: 0, ticks: 0, differ: 0, untold: 0, fewest_x: Infinity }]));
let bytes = 0, begun = 0, done = 0;

/** What `galilean log rerun --json` says of the file, and how it ended. */
async function rerun(build, file) {
  const child = spawn(binary(build), ['log', 'rerun', file, '--json'], { stdio: ['ignore', 'pipe', 'pipe'] });
  const said = { stdout: '', stderr: '' };
  for (const stream of ['stdout', 'stderr']) child[stream].setEncoding('utf8').on('data', (text) => (said[stream] += text));
  const status = await new Promise((resolve) => child.on('close', resolve));
  return { status, ...said };
}

function add(sum, run) {
  sum.runs += 1;
  sum.ticks += run.ticks;
  sum.differ += run.divergence ? 1 : 0;
  sum.untold += run.cannot_tell ? 1 : 0;
  sum.fewest_x = Math.min(sum.fewest_x, run.recorded_s / run.took_s);
}

async function recordAndRerun(number, domain) {
  const file = await record(number, domain);
  bytes += statSync(file).size;
  let good = true;
  for (const build of builds) {
    const { status, stdout, stderr } = await rerun(build, file);
    for (const line of stdout.trim().split('\n').filter(Boolean)) add(sums[build], JSON.parse(line));
    good &&= status === 0;
    if (status !== 0) console.log(`${file} with ${build}: exit code ${status}\n${stdout}${stderr}`);
  }
  if (good) rmSync(file);
  if (++done % 10 === 0) console.log(`${done} recordings: ${JSON.stringify(sums)}`);
}

/** One team after the other in one DDS domain: there are fewer domains than recordings. */
async function work() {
  const domain = freshDomain();
  while (begun < Number(asked.recordings)) await recordAndRerun(++begun, domain);
}
await Promise.all(Array.from({ length: Number(asked['at-once']) }, work));
console.log(`${asked.recordings} recordings, ${(bytes / 1e6).toFixed(0)} MB`);
for (const [build, { runs, ticks, differ, untold, fewest_x }] of Object.entries(sums))
  console.log(`${build}: ${differ} of ${runs} runs differ, ${untold} cannot be told of, in ${ticks} ticks; the slowest ran ${fewest_x.toFixed(0)} × real time, ${(fewest_x / WANTED_X).toFixed(2)} of ${WANTED_X}`);
const bad = Object.values(sums).some(({ runs, differ, untold }) => runs === 0 || differ + untold > 0);
if (!bad) rmSync(folder, { recursive: true });
process.exit(bad ? 1 : 0);
