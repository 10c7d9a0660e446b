// SPDX-License-Identifier: BSD-3-Clause
// The page's files, 1 KB and 100 KB, to 64 connections, in requests a second beside nginx with one worker:
//   node tests/bench/server/static_files.mjs
import { randomBytes } from 'node:crypto';
import { mkdirSync, writeFileSync } from 'node:fs';
import { answers, bench, inTurns, monitorCommand, output, peer, scratchFolder, start, startNginx } from './tools.mjs';

const sizes = { '1 KB': 1 << 10, '100 KB': 100 << 10 };

await bench(async () => {
  const wrk = peer('wrk', 'GALILEAN_WRK', 'wrk');
  const scratch = scratchFolder(), folder = `${scratch}/page`;
  mkdirSync(`${folder}/assets`, { recursive: true });
  writeFileSync(`${folder}/index.html`, '<!doctype html><title>bench</title>');
  for (const size of Object.values(sizes)) writeFileSync(`${folder}/assets/${size}.js`, randomBytes(size));

  const servers = { monitor: await monitorCommand(folder, scratch), nginx: await startNginx(folder, scratch) };
  for (const { command, args, port } of Object.values(servers)) {
    start(command, args);
    await answers(`http://127.0.0.1:${port}/`);
  }
  const requestsASecond = (port, size) => () =>
    Number(output(wrk, ['-t1', '-c64', '-d3s', `http://127.0.0.1:${port}/assets/${size}.js`]).match(/Requests\/sec:\s+([\d.]+)/)[1]);
  for (const [name, size] of Object.entries(sizes)) {
    const { monitor, nginx } = await inTurns(3, {
      monitor: requestsASecond(servers.monitor.port, size),
      nginx: requestsASecond(servers.nginx.port, size),
    });
    console.log(`${name}: monitor ${(monitor / 1e3).toFixed(1)} k requests/s, nginx ${(nginx / 1e3).toFixed(1)} k, ${(monitor / nginx).toFixed(2)} times as many`);
  }
});
