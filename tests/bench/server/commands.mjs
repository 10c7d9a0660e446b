// SPDX-License-Identifier: BSD-3-Clause
// How long an operator's command takes to be answered, alone and beside 1,000 clients that read all of a team's topics but
// its pictures, of whom 100 stop reading, while 50 others have a megabyte each checked and 10 ask for the status without end:
//   node tests/bench/server/commands.mjs [CLIENTS:STALLED=1000:100] [ROBOTS=3] [COMMANDS=1000]
import { commandTimes, crowded, p99 } from '../../tools/crowded.mjs';
import { channels } from './channels.mjs';
import { bench, freePort, line, program, scratchFolder, start } from './tools.mjs';

const LIMIT_MS = 20, CHECKS = 50, FLOODS = 10;
const [clients = '1000:100'] = process.argv.slice(2);
const [robots = 3, commands = 1000] = process.argv.slice(3).map(Number);
const [viewers, stalled = 0] = clients.split(':').map(Number);

await bench(async () => {
  const port = await freePort(), url = `http://127.0.0.1:${port}`;
  const demo = start(program('galilean'), ['demo', '--port', String(port), '--robots', String(robots)], { cwd: scratchFolder() });
  const [, token] = await line(demo, /#token=([0-9A-Za-z_-]+)/);
  const ids = await channels(port, robots);
  const alone = await commandTimes(url, token, commands);
  const beside = await crowded({ port, ids, crowdBench: program('crowd_bench'), viewers, stalled, checks: CHECKS, floods: FLOODS },
    () => commandTimes(url, token, commands));
  const [alone_ms, beside_ms] = [p99(alone), p99(beside)];
  console.log(`${commands} commands beside ${viewers} clients of whom ${stalled} stopped reading, ${CHECKS} checks of a megabyte and ${FLOODS} floods: `
    + `99 of 100 within ${beside_ms.toFixed(1)} ms, ${(beside_ms / LIMIT_MS).toFixed(2)} × the limit of ${LIMIT_MS} ms; `
    + `alone within ${alone_ms.toFixed(1)} ms, ${(beside_ms / alone_ms).toFixed(1)} × less; the slowest took ${beside.at(-1).toFixed(1)} ms`);
});
