// SPDX-License-Identifier: BSD-3-Clause
// From a push over DDS to the answer of the last robot that it runs, with the real executables:
//   node tests/bench/push_latency.mjs [ROBOTS=3] [PUSHES=20]
// The robots have no board and no camera, which changes nothing about how they take a program.
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { freshDomain } from '../tools/domain.mjs';

const root = new URL('../..', import.meta.url).pathname;
const binaries = `${process.env.GALILEAN_BUILD ?? `${root}build`}/bin`;
const robots = Number(process.argv[2] ?? 3);
const pushes = Number(process.argv[3] ?? 20);
const env = { ...process.env, ROS_DOMAIN_ID: freshDomain() };
const folder = mkdtempSync(join(tmpdir(), 'galilean-push-'));

const program = (duration) => `variables: bits: name: "time" end
perceptual_schemas: time_detector: name: "wait" bits_variable: "time" duration: ${duration} end end
state: name: "one" perceptual_schemas: "wait" end
  condition: bits_variable: "time" new_state: "two" end
end
state: name: "two" perceptual_schemas: "wait" end
  condition: bits_variable: "time" new_state: "one" end
end
`;
const file = (number) => {
  const path = join(folder, 'pushed.bhdl');
  writeFileSync(path, program(5 + number));
  return path;
};

/** The answers' latencies in ms, of one push to all. */
function push(number) {
  const direct = spawnSync(`${binaries}/galilean-swap`, ['--help'], { encoding: 'utf8' }).stdout.includes('--direct') ? ['--direct'] : [];
  const done = spawnSync(`${binaries}/galilean-swap`, [file(number), '--team', '--json', '--timeout', '10', ...direct], { env, encoding: 'utf8' });
  const answers = JSON.parse(done.stdout).replies;
  if (answers.length !== robots || !answers.every((each) => each.status === 'running'))
    throw new Error(`not every robot runs it:\n${done.stdout}${done.stderr}`);
  return answers.map((each) => each.latency_ms);
}

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

const team = Array.from({ length: robots }, (_, index) =>
  spawn(`${binaries}/galilean-robot`, ['--name', `r${index}`, '--bhdl', file(0), '--serial', '/dev/null/none', '--camera', 'shm:none',
    '--accept-swaps-from', 'swap', '--log-level', 'error'], { env, stdio: ['ignore', 'ignore', 'inherit'] }));
try {
  await new Promise((resolve) => setTimeout(resolve, 2000 + 100 * robots));
  const all = Array.from({ length: pushes }, (_, index) => push(index + 1));
  const last = all.map((latencies) => Math.max(...latencies));
  console.log(`${robots} robots, ${pushes} pushes: the last answer came after ${median(last).toFixed(1)} ms (median), `
    + `${Math.max(...last).toFixed(1)} ms (longest); one answer after ${median(all.flat()).toFixed(1)} ms (median)`);
} finally {
  for (const robot of team) robot.kill('SIGINT');
  rmSync(folder, { recursive: true });
}
