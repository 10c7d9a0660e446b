// SPDX-License-Identifier: BSD-3-Clause
// The table in docs/RELIABILITY.md: between two marks, a line for each row of a group.
import { readFileSync, writeFileSync } from 'node:fs';

export const DOCUMENT = new URL('../../docs/RELIABILITY.md', import.meta.url).pathname;
const BEGIN = '<!-- faults: begin, written by scripts/reliability.mjs -->', END = '<!-- faults: end -->';
const HEAD = ['| fault | promised | tried | worst |', '|---|---|---|---|'];
const NOT_TRIED = 'not tried yet';

const cells = (line) => line.split(' | ').map((each) => each.replace(/^\| | \|$/g, '').trim());
const key = (fault, promised) => `${fault} | ${promised}`;

const parts = (text) => {
  const [begin, end] = [text.indexOf(BEGIN), text.indexOf(END)];
  if (begin < 0 || end < begin) throw new Error(`${DOCUMENT} has no table between '${BEGIN}' and '${END}'`);
  return [text.slice(0, begin + BEGIN.length), text.slice(begin + BEGIN.length, end), text.slice(end)];
};

/** What stands in the table now, by fault and promise: how often it was tried, and the worst figure, as texts. */
export function told(text = readFileSync(DOCUMENT, 'utf8')) {
  const rows = parts(text)[1].split('\n').filter((line) => line.startsWith('| ')).map(cells);
  return new Map(rows.map(([fault, promised, tried, worst]) => [key(fault, promised), { tried, worst }]));
}

/** The lines of the table. `measured` has { times, worst, broken } by row; of others `before` is kept. */
export function table(groups, measured, before) {
  const line = (row) => {
    const now = measured.get(row);
    const kept = before.get(key(row.fault, row.promised)) ?? { tried: NOT_TRIED, worst: '' };
    const worst = now && (now.worst === null ? 'none' : `${Number(now.worst.toFixed(3))} ${row.unit}`);
    const figures = now ? [now.times, now.broken.length > 0 ? `${worst}, **broken**` : worst] : [kept.tried, kept.worst];
    return `| ${[row.fault, row.promised, ...figures].join(' | ')} |`;
  };
  return [...HEAD, ...groups.flatMap(({ rows }) => rows.map(line))];
}

/** Writes what was measured into the document. */
export function write(groups, measured) {
  const text = readFileSync(DOCUMENT, 'utf8');
  const [before, , after] = parts(text);
  writeFileSync(DOCUMENT, `${before}\n\n${table(groups, measured, told(text)).join('\n')}\n\n${after}`);
}
