// SPDX-License-Identifier: BSD-3-Clause
// How long `galilean log info` takes of a recording of 4 GB that has a summary, from its start to its end, and how much
// of that is the start of the program:
//   node tests/bench/logs/log_info.mjs [GIGABYTES=4] [ROUNDS=21]
import { bench, inTurns, scratchFolder } from '../server/tools.mjs';
import { writeHollow } from './long_recording.mjs';
import { galilean } from './tools.mjs';

const [gigabytes = 4, rounds = 21] = process.argv.slice(2).map(Number);
const MOST_MS = 100;

await bench(async () => {
  const file = `${scratchFolder()}/hollow.mcap`;
  writeHollow(file, gigabytes * 1e9);
  const { text } = await galilean(['log', 'info', file, '--json'], { keep: true });
  const { messages, chunks, recovered, checked } = JSON.parse(text);
  if (recovered || checked || messages !== 100 * chunks) throw new Error(`it was not told by its summary: ${text.slice(0, 500)}`);
  const took_ms = (...args) => async () => 1000 * (await galilean(args)).took_s;
  const { info, version } = await inTurns(rounds, { info: took_ms('log', 'info', file), version: took_ms('log', '--help') });
  console.log(`log info of ${gigabytes} GB in ${chunks} chunks: ${info.toFixed(1)} ms (median of ${rounds}), ${(info / MOST_MS).toFixed(2)} of ${MOST_MS} ms; log --help takes ${version.toFixed(1)} ms`);
});
