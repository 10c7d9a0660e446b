// SPDX-License-Identifier: BSD-3-Clause
// The break points that are drawn on a machine.

import type { BreakPoint } from "../feed/messages";
import type { BreakKind } from "../feed/parts";

export interface BreakMarks {
  /** By the state that is entered, from wherever. */
  readonly entering: ReadonlyMap<string, BreakKind>;
  /** By the state that is left, to wherever. */
  readonly leaving: ReadonlyMap<string, BreakKind>;
  /** By "from → to". */
  readonly arrows: ReadonlyMap<string, BreakKind>;
}

export const NO_MARKS: BreakMarks = { entering: new Map(), leaving: new Map(), arrows: new Map() };

/** What each kind is called, and its sign in a text. */
export const BREAK_KINDS: Readonly<Record<BreakKind, { readonly sign: string; readonly words: string }>> = {
  stop: { sign: "●", words: "stops the robot" },
  stop_team: { sign: "◉", words: "stops the team" },
  lock: { sign: "■", words: "locked" },
};

export function marksOf(points: readonly BreakPoint[]): BreakMarks {
  const marks = { entering: new Map<string, BreakKind>(), leaving: new Map<string, BreakKind>(), arrows: new Map<string, BreakKind>() };
  for (const { from_state: from, to_state: to, kind } of points) {
    if (!(kind in BREAK_KINDS)) continue;
    const [marked, key] = !from ? [marks.entering, to] : !to ? [marks.leaving, from] : [marks.arrows, `${from} → ${to}`];
    marked.set(key, kind as BreakKind);
  }
  return marks;
}

/** For who hears the graph: "entering it stops the robot, leaving it is locked"; empty: nothing is there. */
export function stateMarkWords({ entering, leaving }: BreakMarks, state: string): string {
  const words = (kind: BreakKind) => (kind === "lock" ? "is locked" : BREAK_KINDS[kind].words);
  const [enters, leaves] = [entering.get(state), leaving.get(state)];
  return [enters && `entering it ${words(enters)}`, leaves && `leaving it ${words(leaves)}`].filter(Boolean).join(", ");
}
