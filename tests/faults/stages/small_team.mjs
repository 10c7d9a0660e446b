// SPDX-License-Identifier: BSD-3-Clause
// Robots without boards and cameras, which take programs and tell all that robots tell, and a monitor.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { freshDomain, Running, scratchFolder } from '../../end_to_end/tools.mjs';
import { Monitor } from './monitor.mjs';

export const PROGRAM = 'state: name: "first" end\n';
let pushed = 0;

/** What is to be pushed: a program that differs from all before. */
export const anotherPush = (more = {}) => ({
  files: [{ path: 'pushed.bhdl', text: `; push ${++pushed}\nstate: name: "first" end\n` }], author: 'faults', probation_s: 0, ...more,
});

export const robotArguments = (name, file) => ['robot', '--name', name, '--bhdl', file, '--serial', '/dev/null/none', '--camera', 'shm:none',
  '--resume-by-itself', '--log-level', 'warning'];

/**
 * Requires: `scope` outlives what is returned. `envs` are those of robots and of the monitor, which is a `monitorOf`. With
 * `trusting`, robots obey only what the monitor has signed.
 */
export async function startSmallTeam(scope, { count = 1, envs = () => ({}), monitorOf = Monitor, trusting = false } = {}) {
  const domain = freshDomain(), cwd = scratchFolder(scope), file = join(cwd, 'first.bhdl'), state = join(cwd, 'state');
  writeFileSync(file, PROGRAM);
  mkdirSync(state);
  const { robots: ofRobots = {}, monitor: ofMonitor = {} } = envs(cwd, state);
  const names = ['io', 'ganymede', 'callisto', 'europa', 'amalthea'].slice(0, count);
  // Who makes the key comes first.
  const monitor = await monitorOf.start(scope, { domain, cwd, env: ofMonitor });
  const trust = trusting ? ['--trust', join(cwd, 'operator.key.pub')] : [];
  const robots = new Map();
  const startRobot = (name) => robots.set(name,
    new Running(scope, [...robotArguments(name, file), ...trust], { domain, cwd, env: { XDG_STATE_HOME: state, ...ofRobots } }));
  for (const name of names) startRobot(name);
  const stage = {
    domain, cwd, file, names, robots, startRobot, monitor,
    well: () => monitor.hears(count),
  };
  await stage.well();
  return stage;
}
