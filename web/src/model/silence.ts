// SPDX-License-Identifier: BSD-3-Clause
import type { Robot } from "./model";

/** State comes ten times a second: two seconds without any are no hiccup. */
export const SILENT_AFTER_S = 2;

/** Seconds since the robot was last heard, by us or by the monitor, whichever knows of longer. */
export function age_s(robot: Robot, now_ms: number): number {
  const ours_s = Math.max((now_ms - robot.heard_ms) / 1000, 0);
  return robot.placed?.silent ? Math.max(ours_s, robot.placed.age_s) : ours_s;
}

/** The names of those that are silent. */
export function silentIn(robots: Iterable<Robot>, now_ms: number): ReadonlySet<string> {
  return new Set([...robots].filter((robot) => isSilent(robot, now_ms)).map(({ name }) => name));
}

export function isSilent(robot: Robot, now_ms: number): boolean {
  return robot.placed?.silent === true || age_s(robot, now_ms) > SILENT_AFTER_S;
}
