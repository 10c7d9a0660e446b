// SPDX-License-Identifier: BSD-3-Clause
// What DDS Security costs: processor time of a robot that only talks (a hundred states, sets of variables and
// pictures of 5 kB a second) and of who listens to the pictures, with keys and without, in turns:
//   node tests/bench/secure_cost.mjs [SECONDS=10] [ROUNDS=3]
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { bench, build, domain, inTurns, line, output, program, scratchFolder, start } from './server/tools.mjs';

const [seconds = 10, rounds = 3] = process.argv.slice(2).map(Number);
const SETTLE_S = 3;
const ticks_a_s = Number(output('getconf', ['CLK_TCK']));
const sleep = (s) => new Promise((resolve) => setTimeout(resolve, s * 1000));

/** Processor seconds of a process, in the system and in itself. */
function used_s(pid) {
  const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /s, '').split(' ');
  return (Number(fields[11]) + Number(fields[12])) / ticks_a_s;
}

/** Throws unless the pictures were asked for nearly all the time: who hears nothing costs nothing. */
function requireHeard({ state, 'camera/compressed': pictures }) {
  const expected = state * seconds / (seconds + SETTLE_S);
  if (pictures < 0.9 * expected) throw new Error(`only ${pictures} of ${Math.round(expected)} pictures were read: the two do not hear each other`);
}

/** The share of a core that talker and listener take, each with the keys in its folder. */
async function share(keysOf) {
  const keys = (name) => ({ GALILEAN_SECURE: keysOf(name) });
  const talker = start(join(build, 'tests/wire_talker'), ['io', domain], { stdio: ['pipe', 'pipe', 'inherit'], env: keys('io') });
  const listener = start(program('galilean-topic'), ['rate', 'io/camera/compressed', '--window', '1000'], { env: keys('record') });
  await sleep(SETTLE_S);
  const before = [talker, listener].map(({ pid }) => used_s(pid));
  await sleep(seconds);
  const after = [talker, listener].map(({ pid }) => used_s(pid));
  talker.stdin.end('.');
  requireHeard(JSON.parse((await line(talker, /^\{.*\}$/m))[0]));
  await Promise.all([talker.end(), listener.end()]);
  return after.map((each, i) => each - before[i]).reduce((a, b) => a + b) / seconds;
}

await bench(async () => {
  const team = join(scratchFolder(), 'team');
  const make = (...words) => output(program('galilean'), ['team', 'keys', ...words, '--team', team]);
  make('init');
  make('add', 'io', '--role', 'robot');
  make('add', 'record', '--role', 'recorder');
  const shares = await inTurns(rounds, {
    'without keys': () => share(() => ''),
    'with keys': () => share((name) => join(team, 'members', name)),
  });
  for (const [name, each] of Object.entries(shares)) console.log(`${name.padEnd(14)} ${(100 * each).toFixed(1)} % of a core`);
  console.log(`ratio          ${(shares['with keys'] / shares['without keys']).toFixed(2)}`);
});
