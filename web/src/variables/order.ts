// SPDX-License-Identifier: BSD-3-Clause
// In which order the variables stand: those first that decide what the robot does next.

import { type Program, type Variable, Variable_Constants } from "../feed/messages";
import type { Trigger } from "../machine/nearness";

/** The variables that the conditions of a state read, or of all states: their bits, and what sets those. */
export function readIn(program: Pick<Program, "transitions">, triggers: readonly Trigger[], state?: string): Set<string> {
  const read = new Set<string>();
  for (const { from_state, bits_variable, bit_index } of program.transitions) {
    if (state !== undefined && from_state !== state) continue;
    read.add(bits_variable);
    for (const { bits, bit, locate } of triggers) if (bits === bits_variable && bit === bit_index && locate) read.add(locate);
  }
  return read;
}

export interface Interest {
  /** By the conditions of the current state, and by those of any state. */
  readonly readNow: ReadonlySet<string>;
  readonly readEver: ReadonlySet<string>;
  readonly changed: ReadonlySet<string>;
}

/** The names in the order of how much they matter; pictures, whose only number is the frame's, come last. */
export function orderOf(items: readonly Variable[], { readNow, readEver, changed }: Interest): string[] {
  const rank = ({ name, type, valid }: Variable) => {
    const matters = type === Variable_Constants.IMAGE ? 3 : readNow.has(name) ? 0 : readEver.has(name) ? 1 : 2;
    return 4 * matters + 2 * Number(!changed.has(name)) + Number(!valid);
  };
  return [...items].sort((a, b) => rank(a) - rank(b)).map(({ name }) => name);
}

/** Those whose values are others than in an earlier sample. */
export function changedSince(earlier: readonly Variable[], items: readonly Variable[]): Set<string> {
  const before = new Map(earlier.map((variable) => [variable.name, variable]));
  const isOther = ({ name, valid, values }: Variable) => {
    const old = before.get(name);
    return old !== undefined && (old.valid !== valid || values.some((value, i) => value !== old.values[i]));
  };
  return new Set(items.filter(isOther).map(({ name }) => name));
}

/** The items in an order that was found before; those that it does not know come last. */
export function inOrder(items: readonly Variable[], order: readonly string[]): Variable[] {
  const place = new Map(order.map((name, i) => [name, i]));
  const at = ({ name }: Variable) => place.get(name) ?? order.length;
  return [...items].sort((a, b) => at(a) - at(b));
}

/** The same as long as the same robot's program reads the same variables, whatever its numbers are: then the order stays. */
export function orderKey(robot: string, isDescribed: boolean, readEver: ReadonlySet<string>): string {
  return JSON.stringify([robot, isDescribed, ...[...readEver].sort()]);
}
