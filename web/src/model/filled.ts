// SPDX-License-Identifier: BSD-3-Clause
// Changes of state that the monitor heard of after a gap in which it did not hear the robot: the robot had kept them.

/** By robot: ranges of the changes' numbers, both ends included. */
export type Filled = Readonly<Record<string, readonly (readonly [number, number])[]>>;

/** What is said of such a change. */
export const FILLED_WORDS = "filled after a gap";

/** Whether a robot's change of that number fills a gap, as far as the monitor remembers. */
export function isFilled(filled: Filled | undefined, robot: string, number: bigint): boolean {
  return (filled?.[robot] ?? []).some(([first, last]) => BigInt(first) <= number && number <= BigInt(last));
}
