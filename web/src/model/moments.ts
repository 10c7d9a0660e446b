// SPDX-License-Identifier: BSD-3-Clause
// A robot's variables as they were at each of its changes of state.

import type { Transition, Variable, Variables } from "../feed/messages";
import type { Moment } from "./model";

type Moments = ReadonlyMap<bigint, Moment>;

/** As many as transitions are kept. */
const KEPT = 100;

/**
 * The moments with that of a new change. `latest`: the variables told last, which are those of the
 * change's tick or older, as messages of the two topics come in either order.
 */
export function withMoment(moments: Moments, { number, tick }: Transition, latest: Variables | undefined): Moments {
  if (!latest || moments.has(number)) return moments;
  const moment: Moment = latest.tick >= tick ? { after: latest } : { before: latest };
  const kept = [...moments].slice(1 - KEPT);
  return new Map(kept).set(number, moment);
}

/** The moments with the first variables told at or after the tick of the newest changes. */
export function withVariables(moments: Moments, transitions: readonly Transition[], value: Variables): Moments {
  const waiting = transitions.slice(-4).filter(({ number, tick }) => {
    const moment = moments.get(number);
    return moment && !moment.after && value.tick >= tick;
  });
  if (waiting.length === 0) return moments;
  const filled = new Map(moments);
  for (const { number } of waiting) filled.set(number, { ...filled.get(number), after: value });
  return filled;
}

/** A variable at a change of state, and whether the change made it be forgotten. */
export interface ValueThen {
  readonly variable: Variable;
  readonly forgotten: boolean;
}

/**
 * What the robot knew at the change: what it tells of that tick, but of variables that the change
 * made invalid what it told before. Those that conditions tested come first; invalid ones are left out.
 */
export function valuesThen({ before, after }: Moment, { reset_variables, tested }: Transition): ValueThen[] {
  const asked = new Set(tested.map(({ bits_variable }) => bits_variable));
  const earlier = new Map(before?.items.map((variable) => [variable.name, variable]));
  const values = (after ?? before)?.items.map((variable) => {
    const forgotten = reset_variables.includes(variable.name);
    return { variable: (forgotten && earlier.get(variable.name)) || variable, forgotten };
  });
  const known = (values ?? []).filter(({ variable, forgotten }) => variable.valid || forgotten);
  const rank = ({ variable, forgotten }: ValueThen) => (asked.has(variable.name) ? 0 : forgotten ? 1 : 2);
  return known.sort((a, b) => rank(a) - rank(b));
}

/** What a condition was when another fired, or it itself did. */
export type Finding = "fired" | "held too" | "did not hold" | "invalid";

/** Each condition's finding, in their order: the first that holds fires. */
export function findings({ tested }: Transition): Finding[] {
  const fired = tested.findIndex(({ holds }) => holds);
  return tested.map(({ valid, holds }, i) => (i === fired ? "fired" : holds ? "held too" : valid ? "did not hold" : "invalid"));
}
