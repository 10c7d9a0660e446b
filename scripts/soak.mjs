// SPDX-License-Identifier: BSD-3-Clause
// Runs a demo for hours, and each thirty seconds makes another fault:
//   node scripts/soak.mjs [--hours 2] [--robots 3] [--every 30]
// After each fault the team must be well again in time: every robot is heard, is not held, and has no problem. The memory of
// each process must not grow. A recorder counts the messages that are lost. The log ends with an account of the faults, of
// the memory and of what was lost, and its last line is the verdict; the exit code is 0 or 1. Ctrl-C ends it well, with a
// verdict on what was until then. It needs the programs and tests that ./test.sh builds.
import { setTimeout as sleep } from 'node:timers/promises';
import { parseArgs } from 'node:util';
import { processesIn, Running, startTeam } from '../tests/end_to_end/tools.mjs';
import { judgeMemory, memoryOf } from '../tests/faults/memory_line.mjs';
import { flood, soakFaults } from '../tests/faults/soak_faults.mjs';
import { countedOf, memoryLine, Outcomes, recordedOf } from '../tests/faults/soak_summary.mjs';
import { Scope, until } from '../tests/faults/table.mjs';

const { values: asked } = parseArgs({
  options: { hours: { type: 'string', default: '2' }, robots: { type: 'string', default: '3' }, every: { type: 'string', default: '30' } },
});
const [hours, robots, every_s] = [asked.hours, asked.robots, asked.every].map(Number);
if (!(hours > 0 && robots > 0 && every_s >= 10)) {
  console.error('soak.mjs: --hours and --robots must be above 0, and --every at least 10 s');
  process.exit(2);
}

/** How a recorder ends that has counted losses. */
const INCOMPLETE = 3;
const MOST_LOSSES = 20;
const SAMPLE_MS = 5000, WELL_WITHIN_S = 10, ANSWER_MS = 10_000;
const MB = 1 << 20;
const began_ms = performance.now();
const now_s = () => (performance.now() - began_ms) / 1000;
const log = (sentence) => console.log(`${String(Math.floor(now_s())).padStart(6)} s  ${sentence}`);

/** Ends the sleeps when Ctrl-C comes. */
const stopping = new AbortController();
const over = () => stopping.signal.aborted || now_s() >= 3600 * hours;
const rest = (ms) => sleep(Math.max(0, ms), undefined, { signal: stopping.signal }).catch(() => {});
process.on('SIGINT', () => {
  if (stopping.signal.aborted) process.exit(1);
  log('Ctrl-C: ending. Once more ends at once.');
  stopping.abort();
});

const scope = new Scope();
/** The demo, and what is asked of its monitor. */
async function startDemo() {
  const { team, domain, cwd, url, link } = await startTeam(scope, ['--robots', String(robots)]);
  const token = /#token=(\w+)/.exec(link)[1];
  const ask = async (path, body, bearer = token) => {
    const answer = await fetch(`${url}${path}`, {
      method: body ? 'POST' : 'GET', headers: { authorization: `Bearer ${bearer}` }, body: body && JSON.stringify(body), signal: AbortSignal.timeout(ANSWER_MS),
    });
    return { ...(await answer.json()), status: answer.status };
  };
  const status = async () => (await ask('/api/status')).robots;
  const metrics = async () =>
    (await fetch(`${url}/metrics`, { headers: { authorization: `Bearer ${token}` }, signal: AbortSignal.timeout(ANSWER_MS) })).text();
  // Two files at most, so that the disk lasts as long as the soak.
  const recorder = new Running(scope, ['record', '--out', 'soak.mcap', '--pictures', 'none', '--split-size', '200MB', '--max-files', '2'], { domain, cwd });
  return { team, domain, recorder, port: Number(new URL(url).port), ask, status, metrics, names: [] };
}

/** Why the team is not well; undefined if it is. */
async function illness(demo) {
  try {
    const heard = await demo.status();
    if (heard.length < robots) return `${heard.length} robots are heard`;
    const ill = heard.find(({ silent, age_s, held, problems }) => silent || age_s > 1 || held || problems.length > 0);
    return ill && `${ill.name}: ${ill.silent ? 'silent' : ill.held ? 'held' : ill.problems.join(' ') || `${ill.age_s} s old`}`;
  } catch (error) {
    return `the monitor does not answer: ${error.message}`;
  }
}

const faults = soakFaults(rest);
const samples = new Map();
function sampleMemory(demo) {
  for (const { pid, command } of processesIn(demo.domain)) {
    const bytes = memoryOf(pid);
    const [, program] = /^(?:\S*\/)?(galilean\S*)/.exec(command) ?? [];
    const [, robot = ''] = /--name (\w+)/.exec(command) ?? [];
    if (!bytes || !program) continue;
    const name = `${program} ${robot} (${pid})`;
    if (!samples.has(name)) samples.set(name, []);
    samples.get(name).push([now_s(), bytes]);
  }
}

const wrong = [];
const outcomes = new Outcomes();
async function makeFault(demo, number) {
  const [fault, make] = faults[number % faults.length];
  try {
    await make(demo, number);
    const ended_ms = performance.now();
    let why;
    await until(async () => !(why = await illness(demo)), 'the team to be well', WELL_WITHIN_S, 50).catch(() => {});
    if (why) throw new Error(`the team is not well after ${WELL_WITHIN_S} s: ${why}`);
    const well_after_s = (performance.now() - ended_ms) / 1000;
    outcomes.note(fault, well_after_s);
    log(`${fault}: well again after ${well_after_s.toFixed(1)} s`);
  } catch (error) {
    if (stopping.signal.aborted) return; // Ctrl-C in a terminal ends the demo, too
    outcomes.note(fault, undefined);
    wrong.push(`${fault}: ${error.message}`);
    log(`WRONG: ${fault}: ${error.message}`);
  }
}

function judgeAllMemory() {
  for (const [name, list] of samples) {
    const judged = judgeMemory(list);
    log(memoryLine(name, judged));
    if (judged && !judged.flat) wrong.push(`the memory of ${name} grew by ${(judged.growth_bytes / MB).toFixed(1)} MB`);
  }
}

const account = [];
/** Ends the recorder, and notes what it and the monitor have counted. */
async function countLosses({ recorder, metrics }) {
  const { code, signal } = await recorder.stop();
  const { recorded, lost } = recordedOf(recorder.output);
  account.push(`messages: ${recorded} recorded, ${lost} lost and counted`);
  for (const line of recorder.output.split('\n').filter((each) => / lost \d+ of | lacks, /.test(each)).slice(0, MOST_LOSSES)) account.push(`messages: ${line}`);
  if (code !== 0 && code !== INCOMPLETE) wrong.push(`the recorder ended (${signal ?? `exit code ${code}`}): ${recorder.output}`);
  for (const [name, count] of countedOf(await metrics())) account.push(`counted: ${name} ${count}`);
}

let made = 0;
const sampling = { timer: undefined };
try {
  const demo = await startDemo();
  await until(async () => !(await illness(demo)), 'the team to be well at first', 60, 100);
  demo.names = (await demo.status()).map(({ name }) => name);
  sampling.timer = setInterval(() => sampleMemory(demo), SAMPLE_MS);
  demo.team.ended.then(({ code, signal }) => {
    if (over()) return;
    wrong.push(`the demo ended by itself (${signal ?? `exit code ${code}`})`);
    stopping.abort();
  });
  while (!over()) {
    const next_ms = performance.now() + 1000 * every_s;
    await makeFault(demo, made++);
    await rest(next_ms - performance.now());
  }
  clearInterval(sampling.timer);
  await countLosses(demo).catch((error) => {
    if (!stopping.signal.aborted) wrong.push(error.message);
    account.push(`messages: they could not be counted to the end: ${error.message}`);
  });
  if (!stopping.signal.aborted) {
    await flood(demo, rest);
    log('a stranger has invented robots for some seconds, at the end');
    await demo.status().then((heard) => {
      if (heard.length === 0) wrong.push('after a stranger no robot is heard');
    }, (error) => wrong.push(`after a stranger: ${error.message}`));
  }
} catch (error) {
  wrong.push(error.message);
} finally {
  clearInterval(sampling.timer);
  stopping.abort();
  await scope.end();
}
for (const line of [...outcomes.lines(), ...account]) log(line);
judgeAllMemory();
for (const each of wrong) log(`WRONG: ${each}`);
const good = wrong.length === 0 && made > 0;
console.log(`verdict: ${good ? 'good' : 'bad'}: ${made} faults in ${(now_s() / 3600).toFixed(2)} h, ${wrong.length} wrong`);
process.exit(good ? 0 : 1);
