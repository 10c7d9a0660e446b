// SPDX-License-Identifier: BSD-3-Clause
// What it takes to record a team with all its pictures: the recorder's share of a core beside what plain `zstd -1` takes
// of the same bytes, its memory, and what it missed:
//   node tests/bench/logs/record_share.mjs [ROBOTS=30] [SECONDS=60]
// The team is that of the demo. On a machine of few cores it keeps them busy, and more is missed.
import { spawnSync } from 'node:child_process';
import { statSync } from 'node:fs';
import { bench, output, peer, scratchFolder } from '../server/tools.mjs';
import { galilean, infoOf, MOST_MiB, peakMiB, processorSeconds, share, sleep, startRecorder, startTeam } from './tools.mjs';

const [robots = 30, seconds = 60] = process.argv.slice(2).map(Number);
const SETTLE_S = 15;

/** Processor seconds of a command that reads the file. */
function secondsOf(command, file) {
  const { stderr, status } = spawnSync('bash', ['-c', `TIMEFORMAT='%U %S'; time ${command} "$1" > /dev/null`, 'bash', file], { encoding: 'utf8', env: { ...process.env, LC_ALL: 'C' } });
  if (status !== 0) throw new Error(`${command} ended with ${status}: ${stderr}`);
  return stderr.trim().split(/\s+/).slice(-2).map(Number).reduce((a, b) => a + b);
}

await bench(async () => {
  const cwd = scratchFolder(), file = `${cwd}/run.mcap`, plain = `${cwd}/plain.mcap`;
  const zstd = peer('zstd', 'GALILEAN_ZSTD', 'zstd');
  const team = await startTeam({ robots, cwd });
  await sleep(SETTLE_S);
  const recorder = await startRecorder({ file, options: ['--picture-rate', '0', '--min-free', '0'] });
  await sleep(SETTLE_S);
  const [before_s, began] = [processorSeconds(recorder.pid), performance.now()];
  await sleep(seconds);
  const core = (processorSeconds(recorder.pid) - before_s) / ((performance.now() - began) / 1000);
  const [all_s, peak_MiB] = [processorSeconds(recorder.pid), peakMiB(recorder.pid)];
  await recorder.end();
  await team.end();

  const { losses, messages, channels, duration_seconds, chunks } = await infoOf(file);
  const sum = (name) => losses.writers.reduce((all, each) => all + (each[name] ?? 0), 0);
  await galilean(['log', 'convert', file, '--compression', 'none', '--out', plain], { cwd });
  const zstd_s = secondsOf(`${zstd} -1 -q -c`, plain);
  const rate = (bytes) => `${(bytes / duration_seconds / 1e6).toFixed(2)} MB`;
  const pictures = channels.filter(({ topic }) => topic.endsWith('/compressed')).reduce((all, each) => all + each.messages, 0);
  console.log(`${robots} robots: ${Math.round(messages / duration_seconds)} messages a second, ${Math.round(pictures / duration_seconds)} of them pictures, ${rate(statSync(plain).size)}, written as ${rate(statSync(file).size)} in ${chunks} chunks, on ${output('nproc', []).trim()} cores`);
  console.log(`the recorder took ${(100 * core).toFixed(1)} % of a core; with all that DDS brings, ${(all_s / zstd_s).toFixed(1)} times the processor time of zstd -1 on the same bytes`);
  console.log(`its memory was ${peak_MiB.toFixed(1)} MiB at most, ${share(peak_MiB, MOST_MiB)} MiB`);
  console.log(`missed: ${sum('not_received')} (${sum('overrun')} of them because it was too slow), ${(100 * losses.missing / (messages + losses.missing)).toFixed(3)} % of all; left out: ${sum('left_out')}; counted to the end: ${losses.complete}`);
});
