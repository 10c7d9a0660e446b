// SPDX-License-Identifier: BSD-3-Clause
import type { Transition } from "../feed/messages";
import { cycleAtEnd } from "./cycles";

const KEPT = 100;

/** The list with `next` in its place by its number; a number from before the robot's restart drops what was. */
export function withTransition(list: readonly Transition[], next: Transition): readonly Transition[] {
  const newest = list.at(-1);
  if (!newest || next.number === newest.number + 1n) return [...list, next].slice(-KEPT);
  if (list.some((known) => known.number === next.number && known.stamp.sec === next.stamp.sec)) return list;
  const restarted = next.number < newest.number && next.stamp.sec > newest.stamp.sec;
  if (restarted) return [next];
  return [...list, next].sort((a, b) => Number(a.number - b.number)).slice(-KEPT);
}

/** How many changes were never heard of between two that follow one another in the list. */
export function missedBetween(earlier: Transition, later: Transition): number {
  return Math.max(Number(later.number - earlier.number) - 1, 0);
}

/** Fewer rounds than these are listed change by change. */
const COUNTED_ROUNDS = 3;

/** Changes that go round the same states again and again, or one change alone. */
export interface ChangeGroup {
  /** The newest first. */
  readonly changes: readonly Transition[];
  /** How often they go round; 1: a change alone. */
  readonly rounds: number;
  /** There may have been more rounds before the earliest change that is known. */
  readonly isCut: boolean;
  /** The states that they go round, beginning with the one that the earliest change entered. */
  readonly states: readonly string[];
}

/** The changes, the newest group first, with those that repeat themselves put together. */
export function groupedChanges(list: readonly Transition[]): ChangeGroup[] {
  const groups: ChangeGroup[] = [];
  for (let end = list.length; end > 0; ) {
    const group = lastGroup(list, end);
    groups.push(group);
    end -= group.changes.length;
  }
  return groups;
}

function lastGroup(list: readonly Transition[], end: number): ChangeGroup {
  const same = (a: number, b: number) => list[a]!.to_state === list[b]!.to_state && list[a]!.from_state === list[b]!.from_state;
  const cycle = cycleAtEnd(end, heardSince(list, end), COUNTED_ROUNDS, same);
  if (!cycle) return { changes: [list[end - 1]!], rounds: 1, isCut: false, states: [list[end - 1]!.to_state] };
  const changes = list.slice(cycle.from, end).reverse();
  const states = list.slice(cycle.from, cycle.from + cycle.length).map(({ to_state }) => to_state);
  const isCut = cycle.from === 0 && list[0]!.number > 1n;
  return { changes, rounds: Math.floor(changes.length / cycle.length), isCut, states };
}

/** Of a group's changes those that are listed: the newest where it is open, and in any case the one that is opened. */
export function listedIn({ changes }: ChangeGroup, isOpen: boolean, opened: bigint | undefined, most: number): Transition[] {
  return changes.filter(({ number }, i) => number === opened || (isOpen && i < most));
}

/** The index since which no change was missed. */
function heardSince(list: readonly Transition[], end: number): number {
  let from = end - 1;
  while (from > 0 && missedBetween(list[from - 1]!, list[from]!) === 0) from -= 1;
  return from;
}
