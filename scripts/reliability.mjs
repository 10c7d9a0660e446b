// SPDX-License-Identifier: BSD-3-Clause
// Makes each fault of tests/faults so often, and writes into the table of docs/RELIABILITY.md how often, and the worst figure:
//   node scripts/reliability.mjs [--times 1000] [--groups motors,disk] [--keep-document]
// It needs the programs and tests that ./test.sh builds, and a machine that does little else. Ends with 1 if a promise was
// broken or a fault could not be tried. Ctrl-C ends it, and what was measured by then is written.
import { parseArgs } from 'node:util';
import { write } from '../tests/faults/document.mjs';
import { groups } from '../tests/faults/groups.mjs';
import { BROKEN_ENOUGH, Scope, TIMES, tryRow } from '../tests/faults/table.mjs';

const { values: asked } = parseArgs({
  options: { times: { type: 'string', default: '1000' }, groups: { type: 'string' }, 'keep-document': { type: 'boolean', default: false } },
});
const times = Number(asked.times);
const names = asked.groups?.split(',') ?? groups.map(({ name }) => name);
const unknown = names.filter((name) => !groups.some((group) => group.name === name));
if (!(times > 0) || unknown.length > 0) {
  console.error(`reliability.mjs: ${unknown.length > 0 ? `there is no group '${unknown[0]}': they are ${groups.map(({ name }) => name).join(', ')}` : '--times must be a number above 0'}`);
  process.exit(2);
}

const measured = new Map();
let interrupted = false;
process.on('SIGINT', () => {
  if (interrupted) process.exit(1);
  interrupted = true;
  console.log('Ending. What is being tried now does not count. Once more Ctrl-C ends at once.');
});

/** Tries the row in parts, between which it can be interrupted. */
async function tryOften(row, stage) {
  const all = { times: 0, worst: null, broken: [] };
  while (all.times < times && all.broken.length < BROKEN_ENOUGH && !interrupted) {
    const one = await tryRow(row, stage, Math.min(TIMES, times - all.times));
    if (interrupted) break; // Ctrl-C in a terminal ends the programs that are tried, too
    all.times += one.times;
    all.worst = one.worst === null ? all.worst : Math.max(all.worst ?? 0, one.worst);
    all.broken.push(...one.broken);
    if (one.times === 0) break; // it cannot be tried here
  }
  return all;
}

async function tryGroup(group) {
  const scope = new Scope();
  try {
    const stage = await group.setUp(scope);
    for (const row of group.rows) {
      if (interrupted) break;
      const tried = await tryOften(row, stage);
      if (tried.times > 0) measured.set(row, tried);
      console.log(`${group.name}: ${row.fault}. ${row.promised}: ${tried.times} times, worst ${tried.worst?.toFixed(3) ?? 'none'} ${row.unit} of ${row.limit}`);
      for (const each of tried.broken) console.log(`  broken: ${each}`);
      if (tried.broken.length > 0) process.exitCode = 1;
    }
  } catch (error) {
    console.error(`${group.name}: its programs did not start: ${error.message}`);
    process.exitCode = 1;
  } finally {
    await scope.end();
  }
}

for (const group of groups) if (names.includes(group.name) && !interrupted) await tryGroup(group);
if (!asked['keep-document'] && measured.size > 0) write(groups, measured);
if (interrupted) process.exitCode = 1;
process.exit();
