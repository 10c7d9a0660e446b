// SPDX-License-Identifier: BSD-3-Clause
export interface Place {
  readonly x_m: number;
  readonly y_m: number;
}

/** An arrow key moves a body so far. */
const STEP_M = 0.1;
const WAYS: Readonly<Record<string, readonly [x: number, y: number]>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Whole millimetres: sums of tenths have no tail. */
const whole = (value_m: number) => Math.round(value_m * 1000) / 1000;

/** Where a key moves what stands at `from`; undefined where it is no arrow key. */
export function movedBy(from: Place, key: string): Place | undefined {
  const way = WAYS[key];
  return way && { x_m: whole(from.x_m + way[0] * STEP_M), y_m: whole(from.y_m + way[1] * STEP_M) };
}
