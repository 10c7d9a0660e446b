// SPDX-License-Identifier: BSD-3-Clause
// Who has stopped since STOP ALL, and who has not confirmed it.
import { lasting, plural } from "../lib/format";
import type { Team } from "./model";
import { age_s } from "./silence";

/** A robot that has not said since the order that it stands still. */
export interface Unconfirmed {
  readonly name: string;
  /** How long nothing was heard of it, or how long it has been heard and drove on. */
  readonly waits_s: number;
  /** Whether it was heard since the order and moves: it answers, but does not stop. */
  readonly drivesOn: boolean;
}

export interface StopProgress {
  readonly stopped: readonly string[];
  readonly unconfirmed: readonly Unconfirmed[];
}

/**
 * A robot confirms by a state of its own that was received after the order; `known_ms` is what the page knows of. One
 * that stands at a break point has not confirmed yet, because a step would let it go on. One that a recording plays has
 * nothing to stop.
 */
export function stopProgress(team: Team, ordered_ms: number, known_ms: number): StopProgress {
  const stopped: string[] = [];
  const unconfirmed: Unconfirmed[] = [];
  for (const robot of team.robots.values()) {
    const { name, state, breaks } = robot;
    if (team.replayed.has(name)) continue;
    const isHeard = state !== undefined && state.received_ms >= ordered_ms;
    const isHeld = state?.value.held && !breaks?.value.stopped;
    const drivesOn = isHeard && !state?.value.held;
    if (isHeard && (isHeld || state?.value.out_of_service)) stopped.push(name);
    else unconfirmed.push({ name, drivesOn, waits_s: isHeard ? (known_ms - ordered_ms) / 1000 : Math.max(age_s(robot, known_ms), (known_ms - ordered_ms) / 1000) });
  }
  return { stopped, unconfirmed: unconfirmed.sort((a, b) => b.waits_s - a.waits_s) };
}

/** More are counted. */
const MOST_NAMED = 3;

/** "2 of 3 stopped; callisto has not answered for 14 s" */
export function stopSentence({ stopped, unconfirmed }: StopProgress): string {
  const all = stopped.length + unconfirmed.length;
  if (all === 0) return "No robot is heard that could stop.";
  if (unconfirmed.length === 0) return all === 1 ? `${stopped[0]} has stopped.` : `All ${all} robots have stopped.`;
  const named = unconfirmed.slice(0, MOST_NAMED).map(({ name, drivesOn, waits_s }) =>
    drivesOn ? `${name} answers but has not stopped for ${lasting(waits_s)}` : `${name} has not answered for ${lasting(waits_s)}`,
  );
  const others = unconfirmed.length - named.length;
  const rest = others > 0 ? [`and ${plural(others, "more robot")} ${others === 1 ? "has" : "have"} not confirmed`] : [];
  return `${stopped.length} of ${all} stopped; ${[...named, ...rest].join(", ")}.`;
}
