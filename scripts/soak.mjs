// SPDX-License-Identifier: BSD-3-Clause
// Runs a demo for hours, and each thirty seconds makes another fault:
//   node scripts/soak.mjs [--hours 2] [--robots 3] [--every 30]
// After each fault the team must be well again in time: every robot is heard, is not held, and has no problem. The memory of
// each process must not grow. The log's last line is the verdict, and the exit code 0 or 1. Ctrl-C ends it well, with a
// verdict on what was until then. It needs the programs and tests that ./test.sh builds.
import { setTimeout as sleep } from 'node:timers/promises';
import { parseArgs } from 'node:util';
import { processesIn, startTeam } from '../tests/end_to_end/tools.mjs';
import { judgeMemory, memoryOf } from '../tests/faults/memory_line.mjs';
import { flood, soakFaults } from '../tests/faults/soak_faults.mjs';
import { Scope, until } from '../tests/faults/table.mjs';

const { values: asked } = parseArgs({
  options: { hours: { type: 'string', default: '2' }, robots: { type: 'string', default: '3' }, every: { type: 'string', default: '30' } },
});
const [hours, robots, every_s] = [asked.hours, asked.robots, asked.every].map(Number);
if (!(hours > 0 && robots > 0 && every_s >= 10)) {
  console.error('soak.mjs: --hours and --robots must be above 0, and --every at least 10 s');
  process.exit(2);
}

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
  const { team, domain, url, link } = await startTeam(scope, ['--robots', String(robots)]);
  const token = /#token=(\w+)/.exec(link)[1];
  const ask = async (path, body, bearer = token) => {
    const answer = await fetch(`${url}${path}`, {
      method: body ? 'POST' : 'GET', headers: { authorization: `Bearer ${bearer}` }, body: body && JSON.stringify(body), signal: AbortSignal.timeout(ANSWER_MS),
    });
    return { ...(await answer.json()), status: answer.status };
  };
  const status = async () => (await ask('/api/status')).robots;
  return { team, domain, port: Number(new URL(url).port), ask, status, names: [] };
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
async function makeFault(demo, number) {
  const [fault, make] = faults[number % faults.length];
  try {
    await make(demo, number);
    const ended_ms = performance.now();
    let why;
    await until(async () => !(why = await illness(demo)), 'the team to be well', WELL_WITHIN_S, 50).catch(() => {});
    if (why) throw new Error(`the team is not well after ${WELL_WITHIN_S} s: ${why}`);
    log(`${fault}: well again after ${((performance.now() - ended_ms) / 1000).toFixed(1)} s`);
  } catch (error) {
    if (stopping.signal.aborted) return; // Ctrl-C in a terminal ends the demo, too
    wrong.push(`${fault}: ${error.message}`);
    log(`WRONG: ${fault}: ${error.message}`);
  }
}

function judgeAllMemory() {
  for (const [name, list] of samples) {
    const judged = judgeMemory(list);
    if (!judged) {
      log(`memory of ${name}: too few samples`);
      continue;
    }
    const { flat, mean_bytes, growth_bytes, bytes_per_hour } = judged;
    log(`memory of ${name}: ${(mean_bytes / MB).toFixed(1)} MB, ${(bytes_per_hour / MB).toFixed(2)} MB more an hour${flat ? '' : ': it grows'}`);
    if (!flat) wrong.push(`the memory of ${name} grew by ${(growth_bytes / MB).toFixed(1)} MB`);
  }
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
judgeAllMemory();
for (const each of wrong) log(`WRONG: ${each}`);
const good = wrong.length === 0 && made > 0;
console.log(`verdict: ${good ? 'good' : 'bad'}: ${made} faults in ${(now_s() / 3600).toFixed(2)} h, ${wrong.length} wrong`);
process.exit(good ? 0 : 1);
