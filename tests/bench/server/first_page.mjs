// SPDX-License-Identifier: BSD-3-Clause
// From the start of the program to the first page, beside nginx, and what loading MRPT's libraries alone takes:
//   node tests/bench/server/first_page.mjs
import { connect } from 'node:net';
import { spawnSync } from 'node:child_process';
import { within } from '../../tools/patience.mjs';
import { bench, build, inTurns, monitorCommand, scratchFolder, start, startNginx } from './tools.mjs';

const now = () => performance.now();

/** One request, as soon as somebody listens. */
function firstByte(port) {
  return new Promise((resolve) => {
    const attempt = () => {
      const socket = connect(port, '127.0.0.1', () => socket.write('GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n'));
      socket.once('data', (data) => {
        if (!/^HTTP\/1.1 200/.test(data)) throw new Error(String(data));
        socket.destroy();
        resolve();
      });
      socket.once('error', () => setTimeout(attempt, 1));
    };
    attempt();
  });
}

const untilFirstPage = ({ command, args, port }) => async () => {
  const began = now();
  const child = start(command, args);
  await within(firstByte(port), () => `a page from ${command}`);
  const took = now() - began;
  await child.end('SIGTERM');
  return took;
};

const took = (libraries) => () => {
  const began = now();
  spawnSync('/bin/true', [], { env: { ...process.env, LD_PRELOAD: libraries } });
  return now() - began;
};

await bench(async () => {
  const scratch = scratchFolder(), page = `${build}/share/galilean/web`;
  const { monitor, nginx, mrpt, nothing } = await inTurns(15, {
    monitor: untilFirstPage(await monitorCommand(page, scratch)),
    nginx: untilFirstPage(await startNginx(page, scratch)),
    mrpt: took('libmrpt-maps.so.2.5:libmrpt-tfest.so.2.5'),
    nothing: took(''),
  });
  const loading = mrpt - nothing, allowed = 1.5 * nginx + loading;
  console.log(`first page: monitor ${monitor.toFixed(1)} ms, nginx ${nginx.toFixed(1)} ms, loading MRPT ${loading.toFixed(1)} ms; `
    + `${(monitor / allowed).toFixed(2)} of 1.5 × nginx and MRPT's loading`);
});
