// SPDX-License-Identifier: BSD-3-Clause
// What came of faults, as JSON: a list of { group, fault, promised, unit, limit, times, worst, broken, seconds }. A worst figure
// of null says that there is none. Tests keep it by group, and scripts/reliability.mjs makes a table of it.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const FOLDER = new URL('../../build/test-logs/faults/', import.meta.url).pathname;

/** The member of the list for a row that was tried. */
export const summaryOf = (group, { fault, promised, unit, limit }, { times, worst, broken, seconds }) =>
  ({ group: group.name, fault, promised, unit, limit, times, worst, broken, seconds: Number(seconds.toFixed(1)) });

/** Keeps what tests of a group have shown. */
export function keep(name, summaries) {
  mkdirSync(FOLDER, { recursive: true });
  writeFileSync(join(FOLDER, `${name}.json`), `${JSON.stringify(summaries, null, 1)}\n`);
}

export const readSummaries = (file) => JSON.parse(readFileSync(file, 'utf8'));

/** What was tried, by row. Rows that are no more, or promise something else now, are left out. */
export function measuredOf(groups, summaries) {
  const rows = groups.flatMap((group) => group.rows.map((row) => ({ group, row })));
  const found = summaries.map((each) => [rows.find(({ group, row }) => group.name === each.group && row.fault === each.fault && row.promised === each.promised)?.row, each]);
  return new Map(found.filter(([row, { times }]) => row && times > 0));
}
