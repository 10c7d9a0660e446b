// SPDX-License-Identifier: BSD-3-Clause
import type { Robot } from "../model/model";
import { onPageClock_ms } from "../model/robot_clock";

const LATELY_MS = 15_000;
/** It fades in so many steps: finer ones are not seen, and each is drawn. */
const STEPS = 15;

/** Transitions that fired within the last quarter of a minute, by "from → to": 1 just now, falling to 0. */
export function firedLately(robot: Robot, now_ms: number): Map<string, number> {
  const lately = new Map<string, number>();
  for (const { from_state, to_state, stamp } of robot.transitions) {
    const left = 1 - (now_ms - onPageClock_ms(robot, stamp)) / LATELY_MS;
    if (left > 0) lately.set(`${from_state} → ${to_state}`, Math.min(Math.ceil(left * STEPS) / STEPS, 1));
  }
  return lately;
}
