// SPDX-License-Identifier: BSD-3-Clause
import { shortened } from "../lib/format";
import type { ProgramChange, StateBar } from "./model";

const KEPT = 600;

/**
 * The bars with another. A change is told twice, by the transition and by the state after it, in either
 * order; its number tells that it is the same. A lower number that begins later is a robot's restart.
 */
export function withBar(bars: readonly StateBar[], bar: StateBar): readonly StateBar[] {
  const newest = bars.at(-1);
  const restarted = newest && bar.number < newest.number && bar.from_ms > newest.from_ms + RESTART_MS;
  if (!newest || bar.number > newest.number || restarted) return [...bars, bar].slice(-KEPT);
  if (bars.some((known) => known.number === bar.number)) return bars;
  const at = bars.findIndex((known) => known.number > bar.number);
  return [...bars.slice(0, at), bar, ...bars.slice(at)].slice(-KEPT);
}

/** What comes in another order than it happened comes within this. */
const RESTART_MS = 1000;

export function withProgram(list: readonly ProgramChange[], next: ProgramChange): readonly ProgramChange[] {
  return list.at(-1)?.hash === next.hash ? list : [...list, next];
}

export interface DrawnBar {
  readonly state: string;
  readonly from_ms: number;
  readonly to_ms: number;
  /** It began in a silence, and was told afterwards. */
  readonly filled?: true;
}

/**
 * The bars that can be seen between two instants, cut to them. What a robot did while it was silent is not known, unless
 * the changes fill the gap: `isFilled` says so of a change's number.
 */
export function drawnBars(bars: readonly StateBar[], from_ms: number, to_ms: number, silences: readonly Stretch[] = [], isFilled = (_number: bigint): boolean => false): DrawnBar[] {
  return bars.flatMap((bar, i) => {
    const next = bars[i + 1];
    const { state } = bar;
    const stretch = { from_ms: Math.max(bar.from_ms, from_ms), to_ms: Math.min(next?.from_ms ?? to_ms, to_ms) };
    const filled = isFilled(bar.number);
    /** It is known when it ended, because no change between was missed. */
    const isKnown = next?.number === bar.number + 1n && (filled || isFilled(next.number));
    return partsOutside(stretch, isKnown ? [] : silences).map((part) => (filled ? { state, ...part, filled: true as const } : { state, ...part }));
  });
}

interface Stretch {
  readonly from_ms: number;
  readonly to_ms: number;
}

/** The parts of a stretch that no gap covers. Gaps are in their order of time. */
function partsOutside({ from_ms, to_ms }: Stretch, gaps: readonly Stretch[]): Stretch[] {
  const parts: Stretch[] = [];
  let begin_ms = from_ms;
  for (const gap of gaps) {
    if (gap.to_ms <= begin_ms || gap.from_ms >= to_ms) continue;
    parts.push({ from_ms: begin_ms, to_ms: Math.max(gap.from_ms, begin_ms) });
    begin_ms = Math.min(gap.to_ms, to_ms);
  }
  parts.push({ from_ms: begin_ms, to_ms });
  return parts.filter((part) => part.to_ms > part.from_ms);
}

/** The longest part of a bar that no gap covers: there its name is read. Gaps are in their order of time. */
export function namedPart(bar: Stretch, gaps: readonly Stretch[]): Stretch {
  const nothing = { from_ms: bar.from_ms, to_ms: bar.from_ms };
  return partsOutside(bar, gaps).reduce((best, part) => (part.to_ms - part.from_ms > best.to_ms - best.from_ms ? part : best), nothing);
}

/** Narrower labels say nothing. */
const LEAST_LABEL_PX = 20;

/** The labels of marks in a row, each shortened so that it ends before the next mark; empty where there is no room. */
export function markLabels(marks: readonly { readonly x_px: number; readonly words: string }[], end_px: number): string[] {
  return marks.map(({ x_px, words }, i) => {
    const room_px = (marks[i + 1]?.x_px ?? end_px) - x_px - MARK_PX;
    return room_px < LEAST_LABEL_PX ? "" : labelled(words, room_px);
  });
}

/** A mark and the space before and after its label. */
const MARK_PX = 12;
const CHARACTER_PX = 6.8;

/** A state's name in so much room: whole, or shortened in the middle. */
export function labelled(state: string, room_px: number): string {
  return shortened(state, Math.max(Math.floor(room_px / CHARACTER_PX), 2));
}
