// SPDX-License-Identifier: BSD-3-Clause
// How much memory each verb of `galilean log` takes of a recording, and of one that is six times as long, and how long it
// takes of the longer one:
//   node tests/bench/logs/log_verbs.mjs [SECONDS=20] [COPIES=60]
// A team of the demo is recorded for SECONDS. The longer recording has that COPIES times, one behind the other. Inputs
// cannot be repeated so: `rerun` is measured on the recording itself, and on the first half of it.
import { mkdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { bench, scratchFolder } from '../server/tools.mjs';
import { repeat } from './long_recording.mjs';
import { galilean, infoOf, MOST_MiB, share, sleep, startRecorder, startTeam } from './tools.mjs';

const [seconds = 20, copies = 60] = process.argv.slice(2).map(Number);
const TIMES_AS_LONG = 6;
const CHECKED_A_S = 200_000;
const EXPECTATIONS = `every robot: never state is "break_free" for 10 s
every robot: after state becomes "grab_trash", within 5 s state is "backup1"
every robot: always tick overruns = 0, count of transitions >= 1
every robot: rate of ~/state >= 1 Hz
`;

/** The arguments of each verb, with what it may be told to do that costs memory. */
function verbsOn(file, { base, expectations, out }) {
  const written = (...args) => [...args, '--out', out, '--replace'];
  return {
    info: [file], 'info --check': [file, '--check'], cat: [file], 'cat --json': [file, '--json'], csv: [file, 'io/state'], stats: [file],
    'stats --field': [file, '--topic', 'io/state', '--field', 'x_m', 'state'], plot: [file, 'io/state.x_m', 'io/state.state'],
    'plot --svg': [file, 'io/state.x_m', '--svg', `${out}.svg`, '--replace'], 'plot --map': [file, '--map'], verify: [file], diff: [file, file],
    coverage: [file], slice: written(file, '--from', `${seconds / 2}s`), 'slice --with-states': written(file, '--from', `${seconds / 2}s`, '--with-states'),
    merge: written(file, base), recover: written(file), convert: written(file, '--compression', 'none'), check: [file, '--expect', expectations],
  };
}

await bench(async () => {
  const cwd = scratchFolder(), name = (file) => `${cwd}/${file}`;
  const log = (...args) => galilean(['log', ...args], { cwd, mayFail: true });
  const recorder = await startRecorder({ file: name('base.mcap'), options: ['--inputs', '--min-free', '0'] });
  const team = await startTeam({ robots: 3, cwd });
  await sleep(seconds);
  await team.end();
  await recorder.end();
  await log('convert', name('base.mcap'), '--compression', 'none', '--out', name('plain.mcap'));
  writeFileSync(name('bench.expect'), EXPECTATIONS);

  /** The peaks of every verb on a recording with so many copies, and the time that each took. */
  async function measured(times) {
    repeat(name('plain.mcap'), name('raw.mcap'), times);
    await log('convert', name('raw.mcap'), '--out', name('long.mcap'));
    rmSync(name('raw.mcap'));
    mkdirSync(name('out'));
    const verbs = verbsOn(name('long.mcap'), { base: name('base.mcap'), expectations: name('bench.expect'), out: name('out/written.mcap') });
    const figures = {};
    for (const [verb, args] of Object.entries(verbs)) figures[verb] = await log(verb.split(' ')[0], ...args);
    const { messages, duration_seconds } = await infoOf(name('long.mcap'));
    const about = { messages, duration_s: duration_seconds, bytes: statSync(name('long.mcap')).size };
    for (const gone of ['out', 'long.mcap']) rmSync(name(gone), { recursive: true });
    return { figures, about };
  }
  const half = name('half.mcap');
  await log('slice', name('base.mcap'), '--to', `${seconds / 2}s`, '--out', half);
  const [shortRerun, longRerun] = [await log('rerun', half), await log('rerun', name('base.mcap'))];
  const short = await measured(Math.max(1, Math.round(copies / TIMES_AS_LONG)));
  const long = await measured(copies);

  console.log(`3 robots: ${Math.round(short.about.duration_s)} s, and ${Math.round(long.about.duration_s)} s with ${long.about.messages} messages in ${Math.round(long.about.bytes / 1e6)} MB; memory is looked at each 5 ms`);
  const tell = (verb, before, after) =>
    console.log(`log ${verb}: ${before.peak_MiB.toFixed(1)} MiB, then ${after.peak_MiB.toFixed(1)} MiB, ${share(after.peak_MiB, MOST_MiB)} MiB; ${after.took_s.toFixed(2)} s`);
  for (const [verb, figure] of Object.entries(long.figures)) tell(verb, short.figures[verb], figure);
  tell(`rerun (${seconds / 2} s, then ${seconds} s)`, shortRerun, longRerun);
  const checked_a_s = long.about.messages / long.figures.check.took_s;
  console.log(`log check: ${Math.round(checked_a_s)} messages a second, from its start to its end, ${share(checked_a_s, CHECKED_A_S)}`);
});
