// SPDX-License-Identifier: BSD-3-Clause
// What of a robot's program has happened, in counts for its graph and in a sentence.

import type { Program } from "../feed/messages";
import type { MachineCounts } from "../graph/machine_counts";
import { plural } from "../lib/format";
import { conditionKey, type Coverage } from "../model/coverage";
import type { Robot } from "../model/model";
import { onPageClock_ms } from "../model/robot_clock";

export interface MachineCoverage {
  readonly counts: MachineCounts;
  /** How often each condition fired, by its key. */
  readonly fired: ReadonlyMap<string, number>;
  /** How much has happened, since when, and what cannot be known. */
  readonly sentence: string;
}

/** Of the program that the robot tells, up to the instant of which the robot is told. */
export function coverageOf(program: Program, robot: Robot): MachineCoverage {
  const coverage = robot.coverages?.get(program.hash);
  const fired = coverage?.fired ?? new Map<string, number>();
  const counts = { states: stateCounts(program, coverage), arrows: arrowCounts(program, fired) };
  const since_ms = coverage && onPageClock_ms(robot, coverage.since);
  return { counts, fired, sentence: since_ms === undefined ? "No change of state of this program has been heard yet." : sentence(program, counts, coverage!, since_ms) };
}

export function stateCounts({ states }: Program, coverage: Pick<Coverage, "entered"> | undefined): MachineCounts["states"] {
  return new Map(states.map(({ name }) => [name, { never: !coverage?.entered.has(name), times: coverage?.entered.get(name) ?? 0 }]));
}

/** An arrow stands for every condition that leads the same way. */
export function arrowCounts({ transitions }: Program, fired: ReadonlyMap<string, number>): MachineCounts["arrows"] {
  const counts = new Map<string, number>();
  const keys = new Map(transitions.map((condition) => [conditionKey(condition), `${condition.from_state} → ${condition.to_state}`]));
  for (const [key, arrow] of keys) counts.set(arrow, (counts.get(arrow) ?? 0) + (fired.get(key) ?? 0));
  return counts;
}

/** "7 of 10 states, 8 of 15 transitions, 9 of 17 conditions"; without the last where each transition has one condition. */
export function shares({ states, transitions }: Program, counts: MachineCounts, fired: ReadonlyMap<string, number>): string {
  const entered = [...counts.states.values()].filter(({ never }) => !never).length;
  const ways = [...counts.arrows.values()].filter((count) => count > 0).length;
  const conditions = new Set(transitions.map(conditionKey));
  const held = [...conditions].filter((key) => (fired.get(key) ?? 0) > 0).length;
  const parts = [`${entered} of ${plural(states.length, "state")}`, `${ways} of ${plural(counts.arrows.size, "transition")}`];
  if (conditions.size !== counts.arrows.size) parts.push(`${held} of ${plural(conditions.size, "condition")}`);
  return parts.join(", ");
}

function sentence(program: Program, counts: MachineCounts, { fired, fromStart, missed }: Coverage, since_ms: number): string {
  const since = new Date(since_ms).toLocaleTimeString("en-GB");
  return [
    `${shares(program, counts, fired)} have happened since ${since}${fromStart ? ", when this program began" : ""}.`,
    ...(fromStart ? [] : ["What it did before is not known here."]),
    ...(missed > 0 ? [`${plural(missed, "change")} of state ${missed === 1 ? "was" : "were"} not heard, so it may be more.`] : []),
  ].join(" ");
}
