// SPDX-License-Identifier: BSD-3-Clause
import type { Transition } from "../feed/messages";

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
