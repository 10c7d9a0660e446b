// SPDX-License-Identifier: BSD-3-Clause
// What the server's benchmarks share: peers, free ports, ratios of runs that take turns.
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir, userInfo } from 'node:os';
import { join } from 'node:path';
import { freshDomain } from '../../tools/domain.mjs';
import { PATIENCE_MS } from '../../tools/patience.mjs';
import { freePort } from '../../tools/port.mjs';

export { freePort };

export const root = new URL('../../..', import.meta.url).pathname;
export const build = process.env.GALILEAN_BUILD ?? `${root}build`;
export const program = (name) => `${build}/bin/${name}`;
export const domain = freshDomain();

const cleanUps = [];
export const atTheEnd = (action) => cleanUps.unshift(action);

/** Runs `measure`, and whatever happens ends what it started. */
export async function bench(measure) {
  try {
    await measure();
  } catch (error) {
    console.error(error.message);
    process.exitCode = 1;
  } finally {
    for (const action of cleanUps) await action();
  }
}

export function scratchFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'galilean-bench-'));
  atTheEnd(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** A program that others wrote: by the variable that names it, or from the path. */
export function peer(name, variable, debianPackage) {
  const file = process.env[variable] ?? name;
  if (spawnSync('sh', ['-c', `command -v ${file}`]).status !== 0)
    throw new Error(`${name} is missing: apt-get install ${debianPackage}, or name it with ${variable}=FILE`);
  return file;
}

export function start(command, args, options = {}) {
  const child = spawn(command, args, { stdio: ['ignore', 'pipe', 'inherit'], ...options, env: { ...process.env, ROS_DOMAIN_ID: domain, ...options.env } });
  child.text = '';
  child.stdout?.on('data', (data) => { child.text += data; });
  child.ended = new Promise((resolve) => child.on('exit', resolve));
  child.end = (signal = 'SIGINT') => {
    if (child.exitCode === null && child.signalCode === null) child.kill(signal);
    return child.ended;
  };
  atTheEnd(() => child.end());
  return child;
}

/** What `child` says on stdout that matches, as soon as it does. */
export async function line(child, pattern) {
  for (const began = performance.now(); performance.now() - began < PATIENCE_MS;) {
    const match = child.text.match(pattern);
    if (match) return match;
    if (child.exitCode !== null || child.signalCode !== null) throw new Error(`ended before it said ${pattern}: ${child.text}`);
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  throw new Error(`waited ${PATIENCE_MS / 1000} s for ${pattern}: ${child.text}`);
}

/** Until the server says that all is well; it has ten seconds. */
export async function answers(url) {
  for (let status = 'nothing', attempt = 0; status !== 200; ++attempt) {
    if (attempt === 500) throw new Error(`${url} answers ${status}`);
    status = await fetch(url).then((response) => response.status, (error) => error.message);
    if (status !== 200) await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

export const output = (command, args, options = {}) => execFileSync(command, args, { encoding: 'utf8', ...options });
export const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** Lets the measurements take turns, and gives the median of each by its name. */
export async function inTurns(rounds, measurements) {
  const all = Object.fromEntries(Object.keys(measurements).map((name) => [name, []]));
  for (let round = 0; round < rounds; ++round)
    for (const [name, measure] of Object.entries(measurements)) all[name].push(await measure());
  return Object.fromEntries(Object.entries(all).map(([name, values]) => [name, median(values)]));
}

/** nginx with one worker that serves `folder`. */
export async function startNginx(folder, scratch) {
  const nginx = peer('nginx', 'GALILEAN_NGINX', 'nginx-light');
  const port = await freePort();
  writeFileSync(`${scratch}/nginx.conf`, `daemon off; worker_processes 1; user ${userInfo().username}; pid ${scratch}/nginx.pid; error_log /dev/null;
events { worker_connections 1024; }
http {
  access_log off; sendfile on; tcp_nopush on; keepalive_requests 100000000; types { text/javascript js; text/html html; }
  client_body_temp_path ${scratch}/body; proxy_temp_path ${scratch}/proxy; fastcgi_temp_path ${scratch}/fastcgi;
  uwsgi_temp_path ${scratch}/uwsgi; scgi_temp_path ${scratch}/scgi;
  server { listen 127.0.0.1:${port}; root ${folder}; }
}
`);
  return { port, command: nginx, args: ['-p', scratch, '-c', `${scratch}/nginx.conf`, '-e', '/dev/null'] };
}

export const monitorCommand = async (folder, scratch) => {
  const port = await freePort();
  return { port, command: program('galilean-monitor'), args: ['--listen', `127.0.0.1:${port}`, '--data', scratch, '--web', folder] };
};

/** Processor seconds that a monitor has used, as it says itself. */
export async function processorSeconds(url) {
  const text = await (await fetch(`${url}/metrics`)).text();
  return Number(text.match(/^process_cpu_seconds_total (\S+)/m)[1]);
}
