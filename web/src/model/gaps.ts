// SPDX-License-Identifier: BSD-3-Clause
/** A time in which the page heard nothing, on the page's clock. */
export interface Gap {
  readonly from_ms: number;
  readonly to_ms: number;
}

const KEPT_MS = 600_000;

/** The gaps with another, as far back as the page remembers anything. */
export function withGap(gaps: readonly Gap[], gap: Gap): readonly Gap[] {
  return [...gaps.filter(({ to_ms }) => to_ms > gap.to_ms - KEPT_MS), gap];
}

/** The gaps, apart from each other and in their order of time, with one that they may know already in part. */
export function withJoined(gaps: readonly Gap[], gap: Gap): readonly Gap[] {
  const isApart = (other: Gap) => other.to_ms < gap.from_ms || other.from_ms > gap.to_ms;
  const joined = gaps.filter((other) => !isApart(other)).reduce((one, { from_ms, to_ms }) => ({ from_ms: Math.min(one.from_ms, from_ms), to_ms: Math.max(one.to_ms, to_ms) }), gap);
  return [...gaps.filter((other) => isApart(other) && other.to_ms > gap.to_ms - KEPT_MS), joined].sort((a, b) => a.from_ms - b.from_ms);
}

/** What of the gaps is seen between two instants, cut to them; `open_ms`: since when there is one that has not ended. */
export function drawnGaps(gaps: readonly Gap[], open_ms: number | undefined, from_ms: number, to_ms: number): Gap[] {
  const all = open_ms === undefined ? gaps : [...gaps, { from_ms: open_ms, to_ms }];
  return all
    .map((gap) => ({ from_ms: Math.max(gap.from_ms, from_ms), to_ms: Math.min(gap.to_ms, to_ms) }))
    .filter((gap) => gap.to_ms > gap.from_ms);
}
