// SPDX-License-Identifier: BSD-3-Clause
// What scripts/soak.mjs does to a demo, in turn: a name, and make(demo, number). Each ends the fault itself.
import { spawn } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { connect } from 'node:net';
import { processesIn } from '../end_to_end/tools.mjs';
import { testTool } from '../logs/tools.mjs';
import { closeOf, endChild } from './stages/children.mjs';

const FAULT_S = 3, FLOOD_S = 5, IDLE = 300;

/** A stranger writes for some seconds. The robots that he invents stay known, as silent ones. */
export async function flood(demo, rest) {
  const stranger = spawn(testTool('wire_stranger'), [demo.domain], { stdio: ['pipe', 'ignore', 'inherit'] });
  stranger.stdin.on('error', () => {}); // it has ended
  const closed = closeOf(stranger);
  await rest(1000 * FLOOD_S);
  await endChild(stranger, closed, () => stranger.stdin.end());
}

const signalled = async (demo, words, name, found = processesIn(demo.domain).filter(({ command }) => words.test(command))) => {
  if (found.length === 0) throw new Error(`no process is ${words}`);
  for (const { pid } of found) process.kill(pid, name);
  return found;
};

const pushed = (text, expected) => async (demo, number) => {
  const { status, state, detail } = await demo.ask('/api/push', { files: [{ path: 'soak.bhdl', text: `; ${number}\n${text}` }], probation_s: 0, author: 'soak' });
  if (status !== expected) throw new Error(`a push was answered with ${status}: ${detail}`);
  if (status === 200 && state !== 'done') throw new Error(`a push is ${state}`);
};

async function wrongTokens(demo) {
  await Promise.all(Array.from({ length: 20 }, async () => {
    const { status } = await demo.ask('/api/command', { kind: 'hold' }, randomBytes(32).toString('hex'));
    if (status < 400) throw new Error(`a wrong token was answered with ${status}`);
  }));
}

/** `rest(ms)` waits so long, or less where all is to end. */
export function soakFaults(rest) {
  const paused = (words) => async (demo) => {
    const found = await signalled(demo, words, 'SIGSTOP');
    await rest(1000 * FAULT_S);
    await signalled(demo, words, 'SIGCONT', found);
  };
  const broken = (part) => async (demo, number) => {
    const subject = demo.names[number % demo.names.length];
    const order = async (kind) => {
      const { status, detail } = await demo.ask('/api/simulation/orders', { order: kind, subject, part });
      if (status !== 200) throw new Error(`${kind} ${part} of ${subject}: ${status} ${detail}`);
    };
    await order('break');
    await rest(1000 * FAULT_S);
    await order('mend');
  };
  async function idle(demo) {
    const sockets = Array.from({ length: IDLE }, () => connect(demo.port, '127.0.0.1').on('error', () => {}));
    await rest(1000 * FAULT_S);
    for (const socket of sockets) socket.destroy();
  }

  return [
    [`a robot stands still for ${FAULT_S} s`, paused(/galilean-robot .*--name io/)],
    [`the monitor stands still for ${FAULT_S} s`, paused(/galilean-monitor /)],
    [`the simulator stands still for ${FAULT_S} s`, paused(/galilean-sim /)],
    [`a camera is unplugged for ${FAULT_S} s`, broken('camera')],
    [`a serial line is unplugged for ${FAULT_S} s`, broken('serial_line')],
    ['a program with errors is pushed', pushed('state: nmae: "wrong" end\n', 422)],
    ['another program is pushed', pushed('include "sit_and_spin.bhdl"\n', 200)],
    ['the first program is pushed again', pushed('include "office_cleanup.bhdl"\n', 200)],
    [`${IDLE} connections say nothing`, idle],
    ['twenty wrong tokens come', wrongTokens],
  ];
}
