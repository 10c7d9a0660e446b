// SPDX-License-Identifier: BSD-3-Clause
const WINDOW_MS = 2000;

/** Messages heard of a robot: those of the window that is under way, and how many a second came in the last. */
export interface MessageRate {
  readonly from_ms: number;
  readonly count: number;
  readonly per_s?: number;
}

/** After `more` messages, the last of which came at `at_ms`. */
export function withMessages(rate: MessageRate | undefined, at_ms: number, more = 1): MessageRate {
  if (!rate || at_ms < rate.from_ms) return { from_ms: at_ms, count: more };
  const passed_ms = at_ms - rate.from_ms;
  if (passed_ms < WINDOW_MS) return { ...rate, count: rate.count + more };
  return { from_ms: at_ms, count: more, per_s: (rate.count * 1000) / passed_ms };
}
