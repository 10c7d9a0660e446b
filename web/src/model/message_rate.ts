// SPDX-License-Identifier: BSD-3-Clause
const WINDOW_MS = 2000;

/** Messages heard of a robot: those of the window that is under way, and how many a second came in the last. */
export interface MessageRate {
  readonly from_ms: number;
  readonly count: number;
  readonly per_s?: number;
}

export function withMessage(rate: MessageRate | undefined, at_ms: number): MessageRate {
  if (!rate || at_ms < rate.from_ms) return { from_ms: at_ms, count: 1 };
  const passed_ms = at_ms - rate.from_ms;
  if (passed_ms < WINDOW_MS) return { ...rate, count: rate.count + 1 };
  return { from_ms: at_ms, count: 1, per_s: (rate.count * 1000) / passed_ms };
}
