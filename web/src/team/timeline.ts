import type { ProgramChange, StateBar } from "./model";

const KEPT = 600;

/**
 * The bars with one that begins at `from_ms`. The same change is told twice, by the transition and by
 * the state after it: what begins no later than the newest bar, in the same state, is not news.
 */
export function withBar(bars: readonly StateBar[], state: string, from_ms: number): readonly StateBar[] {
  const newest = bars.at(-1);
  if (!newest) return [{ state, from_ms }];
  if (newest.state === state && from_ms <= newest.from_ms + SAME_MS) return bars;
  if (from_ms > newest.from_ms) return [...bars, { state, from_ms }].slice(-KEPT);
  const at = bars.findIndex((bar) => bar.from_ms > from_ms);
  const before = bars[at - 1];
  if (before && before.state === state && Math.abs(before.from_ms - from_ms) <= SAME_MS) return bars;
  return [...bars.slice(0, at), { state, from_ms }, ...bars.slice(at)].slice(-KEPT);
}

/** Two tellings of one change differ by the clocks' jitter; no two changes fall in one tick. */
const SAME_MS = 60;

export function withProgram(list: readonly ProgramChange[], next: ProgramChange): readonly ProgramChange[] {
  return list.at(-1)?.hash === next.hash ? list : [...list, next];
}

export interface DrawnBar {
  readonly state: string;
  readonly from_ms: number;
  readonly to_ms: number;
}

/** The bars that can be seen between two instants, cut to them. */
export function drawnBars(bars: readonly StateBar[], from_ms: number, to_ms: number): DrawnBar[] {
  return bars
    .map((bar, i) => ({
      state: bar.state,
      from_ms: Math.max(bar.from_ms, from_ms),
      to_ms: Math.min(bars[i + 1]?.from_ms ?? to_ms, to_ms),
    }))
    .filter((bar) => bar.to_ms > bar.from_ms);
}

/** Where a time axis is marked: round ages from now back to the span's beginning. */
export function timeMarks(span_s: number): number[] {
  const step_s = span_s / 6;
  return Array.from({ length: 6 }, (_, i) => i * step_s);
}
