// SPDX-License-Identifier: BSD-3-Clause
// Parts of messages that several share, or that are looked at alone.

import type { MapObject, Program, Time } from "./messages";

/** A program's states and the ways between them. */
export type Machine = Pick<Program, "start_state" | "states" | "transitions">;

/** How sure a place is, in m². */
export type Covariance = Pick<MapObject, "variance_xx" | "variance_xy" | "variance_yy">;

/** What a break point does: the robot stands still, every robot does, or the change waits for an operator. */
export type BreakKind = "stop" | "stop_team" | "lock";

/** A change of state by its two states; an empty one stands for any. */
export interface StateChange {
  readonly from: string;
  readonly to: string;
}

export function seconds(time: Time): number {
  return time.sec + time.nsec / 1e9;
}

/** The names of constants of the IDL in lower case, each at the index that is its value. */
export function namesOf<T extends Readonly<Record<string, number>>>(constants: T): readonly (Lowercase<keyof T & string> | undefined)[] {
  const names: Lowercase<keyof T & string>[] = [];
  for (const [name, value] of Object.entries(constants)) names[value] = name.toLowerCase() as Lowercase<keyof T & string>;
  return names;
}
