// SPDX-License-Identifier: BSD-3-Clause
export interface TimeSpan {
  readonly from_ms: number;
  readonly to_ms: number;
}

/** Below, states' bars say no more; above, nothing is kept. */
const SHORTEST_S = 5;
const LONGEST_S = 1800;

export function clampSpan_s(span_s: number): number {
  return Math.min(Math.max(span_s, SHORTEST_S), LONGEST_S);
}

/** The span made longer by `factor`, with `at_ms` where it was in it. */
export function zoomed({ from_ms, to_ms }: TimeSpan, factor: number, at_ms: number): TimeSpan {
  const before_ms = to_ms - from_ms;
  const after_ms = clampSpan_s((before_ms * factor) / 1000) * 1000;
  const share = before_ms > 0 ? (at_ms - from_ms) / before_ms : 1;
  return { from_ms: at_ms - share * after_ms, to_ms: at_ms + (1 - share) * after_ms };
}

export interface TimeMark {
  readonly at_ms: number;
  /** How long before the reference. */
  readonly ago_s: number;
}

const STEPS_S = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600];

/** How long ago a mark is: "now", "−90 s", "−2.5 min". */
export function markWords(ago_s: number): string {
  if (ago_s === 0) return "now";
  return ago_s < 120 ? `−${ago_s} s` : `−${Number((ago_s / 60).toFixed(1))} min`;
}

/** Round ages, counted back from `reference_ms`, that fall into the span: six or so. */
export function timeMarks({ from_ms, to_ms }: TimeSpan, reference_ms: number): TimeMark[] {
  const wanted_s = (to_ms - from_ms) / 1000 / 7;
  const step_s = STEPS_S.find((step) => step >= wanted_s) ?? STEPS_S.at(-1)!;
  const first = Math.max(Math.ceil((reference_ms - to_ms) / 1000 / step_s - 1e-6), 0);
  const last = Math.floor((reference_ms - from_ms) / 1000 / step_s);
  const count = Math.max(last - first + 1, 0);
  return Array.from({ length: count }, (_, i) => {
    const ago_s = (first + i) * step_s;
    return { at_ms: reference_ms - ago_s * 1000, ago_s };
  });
}
