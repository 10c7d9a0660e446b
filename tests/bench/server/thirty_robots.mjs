// SPDX-License-Identifier: BSD-3-Clause
// The monitor with 30 robots that drive in simulation and one browser that shows them:
//   node tests/bench/server/thirty_robots.mjs [ROBOTS=30] [SECONDS=20]
import { writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { bench, atTheEnd, freePort, line, processorSeconds, program, root, scratchFolder, start } from './tools.mjs';

const require = createRequire(`${root}web/`);
const { chromium } = require('playwright-core');
const [robots = 30, seconds = 20] = process.argv.slice(2).map(Number);
const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** A hall with room for all of them. */
function hall() {
  const across = Math.ceil(Math.sqrt(robots)), side_m = 2.4 * (across + 1);
  const starts = Array.from({ length: robots }, (_, i) => ({ at: [2.4 * (1 + i % across), 2.4 * (1 + Math.floor(i / across))], heading_deg: (37 * i) % 360 }));
  const baskets = [0.15, 0.85].flatMap((x) => [0.15, 0.85].map((y) => ({ at: [x * side_m, y * side_m - 1] })));
  return { name: 'hall', arena: { width_m: side_m, depth_m: side_m }, baskets, pieces: { cans: 2 * robots, cups: 0, wads: 0, clearance_m: 0.35 },
    robots: { starts }, rules: { duration_s: 600 } };
}

await bench(async () => {
  const cwd = scratchFolder(), port = await freePort(), url = `http://127.0.0.1:${port}`;
  writeFileSync(`${cwd}/hall.json`, JSON.stringify(hall()));
  const sim = start(program('galilean-sim'), ['--live', '--scenario', `${cwd}/hall.json`, '--robots', String(robots), '--run', `bench-${port}`, '--autostart', '1'], { cwd });
  const ready = JSON.parse((await line(sim, /^\{.*"ready".*\}$/m))[0]);
  for (const { name, serial, camera } of ready.robots)
    start(program('galilean-robot'), ['--name', name, '--bhdl', `${root}bhdl/programs/office_cleanup.bhdl`, '--serial', serial, '--camera', camera, '--log-level', 'off', '--resume-by-itself'], { cwd });
  const monitor = start(program('galilean-monitor'), ['--listen', `127.0.0.1:${port}`, '--data', cwd], { cwd });
  await line(monitor, /http:\/\//);

  const used = async () => {
    const began = [performance.now(), await processorSeconds(url)];
    await sleep(seconds * 1000);
    return (await processorSeconds(url) - began[1]) / ((performance.now() - began[0]) / 1000);
  };
  await sleep(10_000);
  const alone = await used();
  const browser = await chromium.launch({ executablePath: process.env.GALILEAN_CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
  atTheEnd(() => browser.close());
  await (await browser.newPage()).goto(url);
  await sleep(5_000);
  const watched = await used();
  const { robots: heard } = await (await fetch(`${url}/api/status`)).json();
  console.log(`${heard.filter((robot) => !robot.silent).length} robots: the monitor used ${alone.toFixed(2)} cores alone, ${watched.toFixed(2)} with one browser`);
});
