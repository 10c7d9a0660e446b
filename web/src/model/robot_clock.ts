// SPDX-License-Identifier: BSD-3-Clause
import type { Time } from "../feed/messages";
import { seconds } from "../feed/parts";
import type { Robot } from "./model";

const JUMP_MS = 5000;

/**
 * What to add to a robot's stamps to have the page's clock: the smallest (received − stamp) seen, since
 * what exceeds it is delay. A jump of its clock, as when a simulation starts again, begins anew.
 */
export function clockOffset_ms(before: number | undefined, stamp: Time, received_ms: number): number {
  const sample = received_ms - seconds(stamp) * 1000;
  return before === undefined || Math.abs(sample - before) > JUMP_MS ? sample : Math.min(sample, before);
}

/** Whether its clock went back between two stamps, as a recording's does that begins again. */
export function wentBack(before: Time, after: Time): boolean {
  return (seconds(before) - seconds(after)) * 1000 > JUMP_MS;
}

export function onPageClock_ms(robot: Robot, stamp: Time): number {
  return seconds(stamp) * 1000 + (robot.clock_offset_ms ?? 0);
}
