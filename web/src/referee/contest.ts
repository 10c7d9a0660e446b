// SPDX-License-Identifier: BSD-3-Clause
import type { Strategy } from "../feed/api";
import type { Score } from "../feed/messages";
import type { Stamped } from "../model/model";

/** The referee tells its clock twice a second: who did not hear it for so long does not know it. */
const OLD_S = 3;

/** How old the clock is; undefined while it is as good as new, and where it does not run. */
export function clockAge_s({ value: { phase }, received_ms }: Stamped<Score>, now_ms: number): number | undefined {
  const age_s = (now_ms - received_ms) / 1000;
  return phase === "running" && age_s > OLD_S ? age_s : undefined;
}

/** What is left on the referee's clock, which runs on between its messages, and stands as it was told where it is old. */
export function remaining_s(score: Stamped<Score>, now_ms: number): number {
  const { value: { phase, remaining_s: told_s }, received_ms } = score;
  if (phase !== "running" || clockAge_s(score, now_ms) !== undefined) return told_s;
  return Math.max(told_s - Math.max((now_ms - received_ms) / 1000, 0), 0);
}

/** In less time a rate says nothing. */
const TELLING_S = 30;

export interface RatedStrategy extends Strategy {
  /** Pieces that one robot throws away in a minute; undefined before that says anything. */
  readonly pieces_per_min?: number;
}

/** The best first; those of which too little is known last. */
export function rated(strategies: readonly Strategy[]): RatedStrategy[] {
  const rows = strategies.map((strategy): RatedStrategy => {
    const { robot_seconds, deposited } = strategy;
    return robot_seconds < TELLING_S ? strategy : { ...strategy, pieces_per_min: (deposited * 60) / robot_seconds };
  });
  return rows.sort((a, b) => (b.pieces_per_min ?? -1) - (a.pieces_per_min ?? -1));
}
