// SPDX-License-Identifier: BSD-3-Clause
// What `record --inputs` costs: bytes a second of each robot, and what the robots take of the processor while nobody
// records, while somebody records without inputs, and with them:
//   node tests/bench/logs/inputs_share.mjs [ROBOTS=3] [SECONDS=30] [ROUNDS=3]
// `build/bin/tick_bench --benchmark_filter=inputs` tells of the control loop alone, beside a robot that has no inputs to tell.
import { readFileSync } from 'node:fs';
import { processesIn } from '../../end_to_end/tools.mjs';
import { bench, domain, inTurns, scratchFolder } from '../server/tools.mjs';
import { galilean, processorSeconds, sleep, startRecorder, startTeam } from './tools.mjs';

const [robots = 3, seconds = 30, rounds = 3] = process.argv.slice(2).map(Number);
/** Longer than a robot keeps its inputs for a recorder that comes late. */
const SETTLE_S = 15;
/** After so long a recorder has what robots had kept for it. */
const BEGUN_S = 3;
/** What the option's help promises of a robot with a camera. */
const PROMISED = 1e6;

/** Bytes that all network interfaces of this machine, its loopback among them, have sent. */
const sentBytes = () => readFileSync('/proc/net/dev', 'utf8').split('\n').slice(2, -1).reduce((all, each) => all + Number(each.split(':')[1].trim().split(/\s+/)[8]), 0);

await bench(async () => {
  const cwd = scratchFolder();
  await startTeam({ robots, cwd });
  await sleep(SETTLE_S);
  const team = processesIn(domain).filter(({ command }) => /galilean-robot /.test(command)).map(({ pid }) => pid);
  if (team.length !== robots) throw new Error(`${team.length} of ${robots} robots run`);
  const sent = {};

  /** The robots' share of a core, of each of them, while a recorder with these options runs; undefined: nobody records. */
  const measured = (name, options) => async () => {
    const recorder = options && (await startRecorder({ file: `${cwd}/${name}.mcap`, options: ['--replace', '--pictures', 'none', '--min-free', '0', ...options] }));
    await sleep(BEGUN_S);
    const before = [performance.now(), sentBytes(), team.map(processorSeconds)];
    await sleep(seconds);
    const lasted_s = (performance.now() - before[0]) / 1000;
    (sent[name] ??= []).push((sentBytes() - before[1]) / lasted_s);
    const shares = team.map((pid, i) => (processorSeconds(pid) - before[2][i]) / lasted_s);
    await recorder?.end();
    return shares.reduce((a, b) => a + b) / robots;
  };
  const shares = await inTurns(rounds, { nobody: measured('nobody'), recorded: measured('recorded', []), inputs: measured('inputs', ['--inputs']) });

  const { topics } = JSON.parse((await galilean(['log', 'stats', `${cwd}/inputs.mcap`, '--from', `${BEGUN_S}s`, '--json'], { keep: true })).text);
  const rates = Object.entries(topics).filter(([topic]) => topic.endsWith('/inputs')).map(([, { bytes_per_s }]) => bytes_per_s);
  if (rates.length !== robots) throw new Error(`inputs of ${rates.length} robots were recorded`);
  const [least, most] = [Math.min(...rates), Math.max(...rates)];
  const words = { nobody: 'nobody records', recorded: 'without inputs', inputs: 'with inputs' };
  console.log(`inputs: ${(least / 1e6).toFixed(2)} to ${(most / 1e6).toFixed(2)} MB a second of a robot, ${(most / PROMISED).toFixed(2)} of the 1 MB that the help tells`);
  for (const [name, core] of Object.entries(shares)) {
    const bytes_per_s = [...sent[name]].sort((a, b) => a - b)[rounds >> 1];
    console.log(`${words[name]}: a robot takes ${(100 * core).toFixed(1)} % of a core, ${(core / shares.nobody).toFixed(2)} of what it takes while nobody records; the whole machine sends ${(bytes_per_s / 1e6).toFixed(2)} MB a second`);
  }
});
