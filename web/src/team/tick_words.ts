// SPDX-License-Identifier: BSD-3-Clause
import type { RobotState } from "../feed/messages";

type Tick = Pick<RobotState, "tick_time_us" | "tick_time_max_us" | "tick_period_s" | "overruns">;

/** A tick that takes more than half of its period leaves too little room. */
export function isStrained({ tick_time_max_us, tick_period_s, overruns }: Tick): boolean {
  return tick_time_max_us / 1e6 / tick_period_s > 0.5 || overruns > 0;
}

/** "last tick 27 µs of 20 ms, longest lately 166 µs" */
export function tickWords({ tick_time_us, tick_time_max_us, tick_period_s }: Tick): string {
  return `last tick ${tick_time_us.toFixed(0)} µs of ${(tick_period_s * 1000).toFixed(0)} ms, longest lately ${tick_time_max_us.toFixed(0)} µs`;
}
