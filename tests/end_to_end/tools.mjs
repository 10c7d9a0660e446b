// SPDX-License-Identifier: BSD-3-Clause
// Runs the real executables as a user would, each test in a DDS domain and a folder of its own.
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { freshDomain } from '../tools/domain.mjs';
import { eventually, PATIENCE_MS, within } from '../tools/patience.mjs';
import { freePort } from '../tools/port.mjs';

export { eventually, freePort, freshDomain };

export const root = new URL('../..', import.meta.url).pathname;
export const galileanBinary = `${process.env.GALILEAN_BUILD ?? `${root}build`}/bin/galilean`;
export const programs = `${root}bhdl/programs`;

// Tokens and histories of this file's monitors: neither the user's, nor another test's.
process.env.XDG_STATE_HOME = mkdtempSync(join(tmpdir(), 'galilean-state-'));
process.on('exit', () => rmSync(process.env.XDG_STATE_HOME, { recursive: true, force: true }));

export function scratchFolder(t) {
  const folder = mkdtempSync(join(tmpdir(), 'galilean-test-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** Runs a command to its end, which it must come to by itself. */
export function galilean(args, { domain, cwd, env = {}, input, timeout = PATIENCE_MS } = {}) {
  const own = { ...process.env, ...(domain ? { ROS_DOMAIN_ID: domain } : {}), ...env };
  const { status, signal, error, stdout, stderr } = spawnSync(galileanBinary, args, { env: own, cwd, input, timeout, encoding: 'utf8', maxBuffer: 1 << 28 });
  if (status === null) throw new Error(`galilean ${args.join(' ')} ended by ${error ?? signal}:\n${stdout}${stderr}`, { cause: error });
  return { status, stdout, stderr };
}

/** Becomes the command that is its arguments, whose output goes into a pipe that nobody reads any more. */
const unheardScript = `
  pipe=$(mktemp -u) && mkfifo "$pipe" && exec 3<> "$pipe" 4> "$pipe" 3<&- && rm "$pipe" || exit 125
  exec "$@" >&4 2>&1 4>&-`;

/**
 * A running command: `line(pattern)` waits for output, `stop()` sends SIGINT and waits for the end. What is
 * `unheard` writes into a pipe that has lost its reader.
 */
export class Running {
  constructor(t, args, { domain, cwd, env = {}, unheard = false } = {}) {
    this.name = `galilean ${args[0]}`;
    this.output = '';
    this.waiting = [];
    const [command, ...rest] = unheard ? ['bash', '-c', unheardScript, 'bash', galileanBinary, ...args] : [galileanBinary, ...args];
    this.process = spawn(command, rest, {
      cwd, env: { ...process.env, ...(domain ? { ROS_DOMAIN_ID: domain } : {}), ...env },
    });
    // Not "exit": what it said last comes after that.
    this.ended = new Promise((resolve) => this.process.on('close', (code, signal) => resolve({ code, signal })));
    for (const stream of [this.process.stdout, this.process.stderr]) stream.on('data', (text) => this.#heard(text));
    t.after(() => this.stop());
  }

  #heard(text) {
    this.output += text;
    this.waiting = this.waiting.filter((look) => !look());
  }

  /** How it ended, once it has: its exit code, or the signal that killed it. */
  get exited() {
    return within(this.ended, () => `the end of ${this.name}, which said:\n${this.output}`);
  }

  line(pattern) {
    const said = new Promise((resolve, reject) => {
      const look = () => {
        const match = this.output.match(pattern);
        if (match) resolve(match);
        return match;
      };
      if (look()) return;
      this.waiting.push(look);
      this.ended.then(({ code, signal }) => reject(new Error(`${this.name} ended (${signal ?? `exit code ${code}`}) before it said ${pattern}:\n${this.output}`)));
    });
    return within(said, () => `${this.name} to say ${pattern}; it said:\n${this.output}`);
  }

  async stop(signal = 'SIGINT') {
    if (this.process.exitCode === null && this.process.signalCode === null) {
      this.process.kill(signal);
      this.process.kill('SIGCONT'); // one that stands still hears of it only then
    }
    try {
      return await this.exited;
    } catch (late) {
      this.process.kill('SIGKILL');
      throw late;
    }
  }
}

/** A team that runs: simulator, robots and monitor, by `galilean demo`, whose `link` lets its reader steer. */
export async function startTeam(t, options = []) {
  const domain = freshDomain();
  const port = await freePort();
  const cwd = scratchFolder(t);
  const team = new Running(t, ['demo', '--port', String(port), '--seed', '1', ...options], { domain, cwd });
  const [link] = await team.line(/http:\/\/127\.0\.0\.1:\d+\S*\n/);
  return { team, domain, cwd, url: `http://127.0.0.1:${port}`, link: link.trim() };
}

/** A monitor and one robot that has neither board nor camera: all of the wire, quickly there. */
export async function startMonitor(t, options = [], listen = '127.0.0.1:0') {
  const domain = freshDomain();
  const cwd = scratchFolder(t);
  const monitor = new Running(t, ['monitor', '--listen', listen, '--data', cwd, ...options], { domain, cwd });
  const [, port] = await monitor.line(/http:\/\/[0-9.]+:(\d+)/);
  const url = `http://127.0.0.1:${port}`;
  const robot = new Running(t, ['robot', '--name', 'io', '--bhdl', `${programs}/office_cleanup.bhdl`, '--serial', '/dev/null/none',
    '--camera', 'shm:none', '--log-level', 'off', '--resume-by-itself'], { domain, cwd });
  const token = (name) => readFileSync(join(cwd, `${name}.token`), 'utf8').trim();
  await eventually(async () => {
    const { robots } = await getJson(`${url}/api/status`, { headers: { authorization: `Bearer ${token('operator')}` } });
    return robots.length === 1 && robots[0].program_hash;
  });
  return { monitor, robot, domain, cwd, url, token };
}

export const getJson = async (url, options) => (await fetch(url, options)).json();

/** Processes whose environment names this DDS domain, with their command lines. */
export function processesIn(domain) {
  return readdirSync('/proc').filter((pid) => /^\d+$/.test(pid)).flatMap((pid) => {
    try {
      const inDomain = readFileSync(`/proc/${pid}/environ`, 'utf8').split('\0').includes(`ROS_DOMAIN_ID=${domain}`);
      const command = readFileSync(`/proc/${pid}/cmdline`, 'utf8').replaceAll('\0', ' ');
      return inDomain && command ? [{ pid: Number(pid), command }] : [];
    } catch { return []; }
  });
}

/** The processes that this one started and that have not ended, or for whose end it has not asked. */
export function childrenOf(pid) {
  return readdirSync('/proc').filter((each) => /^\d+$/.test(each)).map(Number).filter((each) => {
    try {
      return Number(readFileSync(`/proc/${each}/stat`, 'utf8').replace(/^.*\) \S /, '').split(' ')[0]) === pid;
    } catch { return false; }
  });
}

export const sharedMemory = () => readdirSync('/dev/shm').filter((name) => name.startsWith('galilean'));
