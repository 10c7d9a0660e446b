// SPDX-License-Identifier: BSD-3-Clause
// Which cell of a grid each state of a machine stands in.

export interface Place {
  readonly column: number;
  readonly row: number;
}

type Way = readonly [from: string, to: string];

/** The states in the order in which they are met from the start on; those never met come last. */
function met(names: readonly string[], start: string, ways: readonly Way[]): string[] {
  const order = names.includes(start) ? [start] : names.slice(0, 1);
  for (let at = 0; at < order.length; at += 1)
    for (const [from, to] of ways) if (from === order[at] && !order.includes(to)) order.push(to);
  return [...order, ...names.filter((name) => !order.includes(name))];
}

/** What the arrows of a placing cost: long ones, upward ones, and those that must swing round a state between. */
function cost(cells: readonly number[], arrows: readonly (readonly [number, number])[], columns: number): number {
  let sum = 0;
  for (const [from, to] of arrows) {
    const [a, b] = [cells[from]!, cells[to]!];
    const across = Math.abs((a % columns) - (b % columns));
    const rows = Math.floor(b / columns) - Math.floor(a / columns);
    const down = Math.abs(rows);
    const between = (across === 0 && down > 1) || (down === 0 && across > 1);
    sum += across * across + down * down + (rows < 0 ? 0.4 : 0) + (between ? 2 : 0);
  }
  return sum;
}

/**
 * Cells in which arrows are short: from the order in which the states are met, two states change
 * places as long as that helps. The start stays in the first cell. The same machine is always placed alike.
 */
export function placed(names: readonly string[], start: string, ways: readonly Way[], columns: number): Map<string, Place> {
  const order = met(names, start, ways);
  const index = new Map(order.map((name, i) => [name, i]));
  const arrows = ways.map(([from, to]) => [index.get(from)!, index.get(to)!] as const);
  const rows = Math.ceil(order.length / columns);
  const cells = Array.from({ length: columns * rows }, (_, i) => i);
  let best = cost(cells, arrows, columns);
  for (let better = true; better; ) {
    better = false;
    for (let a = 1; a < order.length; a += 1)
      for (let b = a + 1; b < cells.length; b += 1) {
        [cells[a], cells[b]] = [cells[b]!, cells[a]!];
        const now = cost(cells, arrows, columns);
        if (now < best - 1e-9) [best, better] = [now, true];
        else [cells[a], cells[b]] = [cells[b]!, cells[a]!];
      }
  }
  return new Map(order.map((name, i) => [name, { column: cells[i]! % columns, row: Math.floor(cells[i]! / columns) }]));
}
