// SPDX-License-Identifier: BSD-3-Clause
// A network that is cut for longer than DDS waits: what robots did meanwhile is told afterwards, or counted as lost.
// GALILEAN_GAP_S=300 tries the longest gap that is promised to be filled; by itself it is a short one.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { freshDomain, galilean, galileanBinary, scratchFolder } from '../end_to_end/tools.mjs';
import { MonitorWithin, startWithin } from './stages/monitor_within.mjs';
import { NO_NETWORK, ownNetwork } from './stages/namespaces.mjs';
import { robotArguments } from './stages/small_team.mjs';
import { Scope, until } from './table.mjs';

/** DDS forgets whom it has not heard for ten seconds. */
const GAP_S = Number(process.env.GALILEAN_GAP_S ?? 15);
/** So long it may take until DDS has connected all anew, on a busy machine. */
const AGAIN_S = 60;
/** Fewer than a robot keeps, and, in any gap, more than the 64 that a late joiner is told. */
const CALM_CHANGES = 900, FEW = 64;

/** A program that changes its state each time that so many seconds are over. */
const program = (pause_s) => `variables: bits: name: "time" end
perceptual_schemas: time_detector: name: "wait" bits_variable: "time" duration: ${pause_s} end end
state: name: "one" perceptual_schemas: "wait" end
  condition: bits_variable: "time" new_state: "two" end
end
state: name: "two" perceptual_schemas: "wait" end
  condition: bits_variable: "time" new_state: "one" end
end
`;
/** One robot changes its state so seldom that it keeps all, the other one oftener than it can keep. */
const PAUSES_S = { calm: Math.max(0.1, (GAP_S + AGAIN_S) / CALM_CHANGES), hasty: 0.001 };
const RATES_HZ = { calm: '20', hasty: '100' };
const NAMES = Object.keys(PAUSES_S);

function startRobot(scope, place, name) {
  const file = join(place.cwd, `${name}.bhdl`);
  writeFileSync(file, program(PAUSES_S[name]));
  return startWithin(scope, place, galileanBinary, [...robotArguments(name, file), '--rate', RATES_HZ[name]]);
}

async function eventsOf(monitor, name) {
  const { channels } = await monitor.ask('/api/status');
  return channels.find(({ topic }) => topic === `rt/${name}/transition`) ?? { messages: 0, filled: 0, lost: 0 };
}

const all = async (question) => (await Promise.all(NAMES.map(question))).every(Boolean);

async function end(child) {
  child.kill('SIGINT');
  await child.ended;
}

test(`a gap of ${GAP_S} s is filled by what robots kept, and the rest is counted`, { timeout: 1000 * (GAP_S + 300) }, async (t) => {
  const scope = new Scope();
  t.after(() => scope.end());
  const network = await ownNetwork(scope);
  assert.ok(network, NO_NETWORK);
  const place = { network, domain: freshDomain(), cwd: scratchFolder(scope) };
  const recording = join(place.cwd, 'run.mcap');
  const monitor = await MonitorWithin.begin(scope, place);
  const recorder = startWithin(scope, place, galileanBinary, ['record', '--out', recording, '--pictures', 'none']);
  const robots = NAMES.map((name) => startRobot(scope, place, name));
  await monitor.hears(NAMES.length);
  await until(() => all(async (name) => (await eventsOf(monitor, name)).messages >= 5), 'the first changes of state');
  for (const name of NAMES) assert.equal((await eventsOf(monitor, name)).filled, 0, name);

  network.lose(100);
  await sleep(1000 * GAP_S);
  network.mend();
  await until(() => all(async (name) => (await eventsOf(monitor, name)).filled > 0), 'what the robots kept', AGAIN_S);
  await sleep(3000); // the recorder may be connected later, and live changes follow
  await Promise.all(robots.map(end));
  await sleep(1000);

  const team = await monitor.ask('/api/team');
  const newest = {};
  for (const name of NAMES) {
    const { transitions } = team.robots.find((robot) => robot.name === name);
    newest[name] = transitions.at(-1).number;
    assert.equal(transitions.at(-1).filled, false, `${name}'s newest change was heard when it happened`);
    const { messages, filled, lost } = await eventsOf(monitor, name);
    t.diagnostic(`${name}: ${newest[name]} changes, of which the monitor was told ${filled} late, and lost ${lost}`);
    assert.equal(messages + lost, newest[name], `${name}: each change is told once or counted as lost`);
    assert.ok(filled > FEW, `${name}: ${filled} filled`);
  }
  assert.equal((await eventsOf(monitor, 'calm')).lost, 0);
  assert.ok((await eventsOf(monitor, 'hasty')).lost > 0);
  assert.ok(team.robots.find(({ name }) => name === 'calm').transitions.some(({ filled }) => filled));
  const metrics = await (await monitor.fetch('/metrics')).text();
  assert.match(metrics, /^galilean_filled_events_total\{topic="rt\/calm\/transition"\} \d+$/m);
  assert.match(metrics, /^galilean_lost_events_total\{topic="rt\/hasty\/transition"\} \d+$/m);

  await end(recorder);
  const { losses } = JSON.parse(galilean(['log', 'info', recording, '--json']).stdout);
  for (const name of NAMES) {
    const told = losses.writers.find(({ topic }) => topic === `/${name}/transition`);
    t.diagnostic(`${name}: the recorder has ${told.recorded}, of which ${told.filled} came late, and lacks ${told.not_received}`);
    assert.equal(told.sent_before + told.recorded + told.not_received, newest[name], `${name}: each change is recorded or counted`);
    assert.ok(told.filled > FEW, `${name}: ${told.filled} filled`);
    assert.equal(told.not_received > 0, name === 'hasty', name);
  }
});
