// SPDX-License-Identifier: BSD-3-Clause
// Makes each fault of tests/faults so often, and writes into the table of docs/RELIABILITY.md how often, and the worst figure:
//   node scripts/reliability.mjs [--times 1000] [--groups motors,disk] [--json build/reliability.json] [--keep-document]
//   node scripts/reliability.mjs --from FILE… [--keep-document]   what was tried before: such a file, or those in
//                                                                 build/test-logs/faults, which ./test.sh faults leaves
// It needs the programs and tests that ./test.sh builds, and a machine that does little else. Says in TAP what came of each
// fault, and as JSON in a file. Ends with 1 if a promise was broken or a fault could not be tried. Ctrl-C ends it, and what
// was measured by then is written.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { parseArgs } from 'node:util';
import { write } from '../tests/faults/document.mjs';
import { groups } from '../tests/faults/groups.mjs';
import { measuredOf, readSummaries, summaryOf } from '../tests/faults/summary.mjs';
import { BROKEN_ENOUGH, figuresOf, Scope, TIMES, tryRow } from '../tests/faults/table.mjs';

const { values: asked, positionals: more } = parseArgs({
  options: {
    times: { type: 'string', default: '1000' }, groups: { type: 'string' }, 'keep-document': { type: 'boolean', default: false },
    json: { type: 'string', default: 'build/reliability.json' }, from: { type: 'string', multiple: true },
  },
  allowPositionals: true,
});
const known = groups.map(({ name }) => name);
const names = asked.groups?.split(',') ?? known;
const times = Number(asked.times);

/** Why it cannot do what it is asked; undefined if it can. */
function objection() {
  const unknown = names.find((name) => !known.includes(name));
  if (unknown !== undefined) return `there is no group '${unknown}': they are ${known.join(', ')}`;
  if (!(times > 0)) return '--times must be a number above 0';
  return more.length > 0 && !asked.from ? `'${more[0]}' is no option` : undefined;
}
if (objection()) {
  console.error(`reliability.mjs: ${objection()}`);
  process.exit(2);
}

const summaries = [];
let interrupted = false;
process.on('SIGINT', () => {
  if (interrupted) process.exit(1);
  interrupted = true;
  console.log('# Ending. What is being tried now does not count. Once more Ctrl-C ends at once.');
});

/** Tries the row in parts, between which it can be interrupted. */
async function tryOften(row, stage) {
  const all = { times: 0, worst: null, broken: [], seconds: 0 };
  while (all.times < times && all.broken.length < BROKEN_ENOUGH && !interrupted) {
    const one = await tryRow(row, stage, Math.min(TIMES, times - all.times), { first: all.times });
    if (interrupted) break; // Ctrl-C in a terminal ends the programs that are tried, too
    all.times += one.times;
    all.seconds += one.seconds;
    all.worst = one.worst === null ? all.worst : Math.max(all.worst ?? 0, one.worst);
    all.broken.push(...one.broken);
    if (one.times === 0) break; // it cannot be tried here
  }
  return all;
}

/** One line of TAP for a row, and what was broken below it. */
function tell(group, row, tried) {
  const isGood = tried.broken.length === 0 && tried.times >= times;
  console.log(`${isGood ? 'ok' : 'not ok'} ${summaries.length} - ${group.name}: ${row.fault}. ${row.promised}`);
  console.log(`# ${figuresOf(row, tried)}`);
  for (const each of tried.broken) console.log(`# broken: ${each.replaceAll('\n', '\n#   ')}`);
  if (!isGood) process.exitCode = 1;
}

async function tryGroup(group) {
  const scope = new Scope();
  try {
    const stage = await group.setUp(scope);
    for (const row of group.rows) {
      if (interrupted) break;
      const tried = await tryOften(row, stage);
      summaries.push(summaryOf(group, row, tried));
      tell(group, row, tried);
    }
  } catch (error) {
    console.log(`not ok - ${group.name}: its programs start\n# ${error.message.replaceAll('\n', '\n#   ')}`);
    process.exitCode = 1;
  } finally {
    await scope.end();
  }
}

async function tryAll() {
  console.log('TAP version 13');
  for (const group of groups) if (names.includes(group.name) && !interrupted) await tryGroup(group);
  console.log(`1..${summaries.length}`);
  mkdirSync(dirname(asked.json), { recursive: true });
  writeFileSync(asked.json, `${JSON.stringify(summaries, null, 1)}\n`);
  console.log(`# what came of them is in ${asked.json}`);
}

if (asked.from) summaries.push(...[...asked.from, ...more].flatMap(readSummaries));
else await tryAll();
const measured = measuredOf(groups, summaries);
if (!asked['keep-document'] && measured.size > 0) write(groups, measured);
if (interrupted) process.exitCode = 1;
process.exit();
