// SPDX-License-Identifier: BSD-3-Clause
import type { RobotState } from "../feed/messages";

/** Less than this is noise of standing. */
const MOVED_M = 0.03;
const TURNED_RAD = 0.1;

export interface Standing {
  readonly x_m: number;
  readonly y_m: number;
  readonly heading_rad: number;
  readonly since_ms: number;
}

/** Where the robot stands by its own reckoning, and since when it has neither moved nor turned from there. */
export function standing(before: Standing | undefined, { x_m, y_m, heading_rad, held }: RobotState, at_ms: number): Standing {
  const turned = before ? Math.abs(Math.atan2(Math.sin(heading_rad - before.heading_rad), Math.cos(heading_rad - before.heading_rad))) : 0;
  const stands = before && !held && Math.hypot(x_m - before.x_m, y_m - before.y_m) < MOVED_M && turned < TURNED_RAD;
  return stands ? before : { x_m, y_m, heading_rad, since_ms: at_ms };
}
