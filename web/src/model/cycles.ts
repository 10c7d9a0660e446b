// SPDX-License-Identifier: BSD-3-Clause
// States that follow one another in the same order again and again.

/** Longer cycles than these are a task, not a loop. */
const LONGEST_CYCLE = 8;

export interface Cycle {
  /** How many states it has. */
  readonly length: number;
  /** The first index of the sequence that belongs to it; the last one is the newest. */
  readonly from: number;
}

/**
 * Returns the shortest cycle that the newest of `count` places repeats to the end, at least `rounds` times, and
 * as far back as it does. `same` compares two places, which both lie at or after `earliest`.
 */
export function cycleAtEnd(count: number, earliest: number, rounds: number, same: (a: number, b: number) => boolean): Cycle | undefined {
  for (let length = 1; length <= LONGEST_CYCLE; length += 1) {
    let from = count - length;
    while (from > earliest && same(from - 1, from - 1 + length)) from -= 1;
    if (from >= earliest && count - from >= rounds * length) return { length, from };
  }
  return undefined;
}
