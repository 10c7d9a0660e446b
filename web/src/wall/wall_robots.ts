// SPDX-License-Identifier: BSD-3-Clause
// What a wall tells of each robot, and of which robots where there is no room for all.

import type { Robot } from "../model/model";
import { isSilent } from "../model/silence";

/** More robots than these get a cell each rather than a row. */
export const ROWS = 5;
/** So many cells are legible at ten metres. */
export const CELLS = 30;

export type Condition = "silent" | "out of service" | "problem" | "held" | "well" | "unknown";

export function conditionOf(robot: Robot, now_ms: number): Condition {
  if (isSilent(robot, now_ms)) return "silent";
  const state = robot.state?.value;
  if (!state) return "unknown";
  if (state.out_of_service) return "out of service";
  if (state.problems.length > 0) return "problem";
  return state.held ? "held" : "well";
}

const WORST_FIRST: readonly Condition[] = ["silent", "problem", "held", "well", "unknown", "out of service"];

export interface ShownRobots {
  readonly shown: readonly Robot[];
  /** How many there is no room for. */
  readonly left: number;
}

/** All of them in their order; where there is no room, the worst off stay, and the last cell says how many are left. */
export function shownRobots(robots: readonly Robot[], now_ms: number): ShownRobots {
  if (robots.length <= CELLS) return { shown: robots, left: 0 };
  const rank = (robot: Robot) => WORST_FIRST.indexOf(conditionOf(robot, now_ms));
  const kept = new Set([...robots].sort((a, b) => rank(a) - rank(b)).slice(0, CELLS - 1));
  return { shown: robots.filter((robot) => kept.has(robot)), left: robots.length - kept.size };
}
