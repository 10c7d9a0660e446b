// SPDX-License-Identifier: BSD-3-Clause
// A robot that goes round the same few states without getting anywhere.

import { cycleAtEnd } from "./cycles";
import type { StateBar, TrailPoint } from "./model";

/** So often the same states must follow one another: a robot that avoids something, or changes its mind, does so less often. */
const ROUNDS = 8;
/** All of it takes at least so long: a bit that flickers on a threshold is over before. */
const LASTS_MS = 5000;
/** A round that takes longer does some work in between, as spinning and then moving on does. */
const ROUND_MS = 3000;
/** Who gets farther than this in a second, on the whole, gets somewhere: it follows a line or a wall. */
const GETS_ON_MPS = 0.05;
/** How far back that is looked at: whoever drives round the arena is not back where it began so soon. */
const LOOKS_BACK_MS = 8000;

export interface Loop {
  /** In the order in which the robot enters them. */
  readonly states: readonly string[];
  /** How often it has gone round. */
  readonly rounds: number;
  readonly from_ms: number;
}

/** What tells of success: when pieces were brought home, and where the robot has been. */
export interface Success {
  readonly deposits_ms: readonly number[];
  readonly trail: readonly TrailPoint[];
}

const isSameState = (bars: readonly StateBar[]) => (a: number, b: number) => bars[a]!.state === bars[b]!.state;

/** Whether the newest states repeat at all, which costs little to know: of most robots they do not. */
export function repeats(bars: readonly StateBar[], now_ms: number): boolean {
  const newest = bars.at(-1);
  return newest !== undefined && now_ms - newest.from_ms <= ROUND_MS && cycleAtEnd(bars.length, 0, ROUNDS, isSameState(bars)) !== undefined;
}

/** Returns the loop that the robot is in. `order` has its program's states as they are written there. */
export function loopOf(bars: readonly StateBar[], { deposits_ms, trail }: Success, order: readonly string[], now_ms: number): Loop | undefined {
  if (!repeats(bars, now_ms)) return undefined;
  const newest = bars.at(-1)!;
  const done_ms = Math.max(-Infinity, ...deposits_ms);
  const cycle = cycleAtEnd(bars.length, heardSince(bars, done_ms), ROUNDS, isSameState(bars));
  if (!cycle || cycle.length < 2) return undefined;
  const from = quickSince(bars, cycle.from, cycle.length);
  const rounds = Math.floor((bars.length - 1 - from) / cycle.length);
  const { from_ms } = bars[from]!;
  if (rounds < ROUNDS || newest.from_ms - from_ms < LASTS_MS || getsOn(trail, from_ms, now_ms)) return undefined;
  return { states: fromFirst(bars.slice(-cycle.length).map(({ state }) => state), order), rounds, from_ms };
}

/** The index since which no change was missed and nothing was brought home. */
function heardSince(bars: readonly StateBar[], done_ms: number): number {
  let from = bars.length - 1;
  while (from > 0 && bars[from - 1]!.from_ms > done_ms && bars[from - 1]!.number + 1n === bars[from]!.number) from -= 1;
  return from;
}

/** The index since which no round took long. */
function quickSince(bars: readonly StateBar[], earliest: number, length: number): number {
  for (let from = bars.length - 1 - length; from >= earliest; from -= 1) {
    if (bars[from + length]!.from_ms - bars[from]!.from_ms > ROUND_MS) return from + 1;
  }
  return earliest;
}

function getsOn(trail: readonly TrailPoint[], from_ms: number, now_ms: number): boolean {
  const last = trail.at(-1);
  if (!last) return false;
  // A trail has no new point while the robot stands: the last one before is where it was then.
  const since_ms = Math.max(from_ms, now_ms - LOOKS_BACK_MS);
  const start = Math.max(trail.filter(({ at_ms }) => at_ms <= since_ms).length - 1, 0);
  const [before, lately] = [trail[start]!, trail.slice(start)];
  const began_ms = Math.max(since_ms, before.at_ms);
  const farthest_m = Math.max(...lately.map(({ x_m, y_m }) => Math.hypot(x_m - before.x_m, y_m - before.y_m)));
  return farthest_m > (GETS_ON_MPS * (now_ms - began_ms)) / 1000;
}

/** The states in their order, beginning with the one that stands first in the program: so the words stay the same. */
function fromFirst(states: readonly string[], order: readonly string[]): string[] {
  const rank = (state: string) => (order.includes(state) ? order.indexOf(state) : order.length);
  const first = states.reduce((best, state, i) => (rank(state) < rank(states[best]!) || (rank(state) === rank(states[best]!) && state < states[best]!) ? i : best), 0);
  return [...states.slice(first), ...states.slice(0, first)];
}
