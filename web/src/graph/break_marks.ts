// SPDX-License-Identifier: BSD-3-Clause
// The break points that are drawn on a machine.

import { kindOf } from "../feed/break_kinds";
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

/** What each kind is called, its sign in a text, and the button that sets it. */
export const BREAK_KINDS: Readonly<Record<BreakKind, { readonly sign: string; readonly words: string; readonly button: string }>> = {
  stop: { sign: "●", words: "stops the robot", button: "Stop" },
  stop_team: { sign: "◉", words: "stops the team", button: "Stop team" },
  lock: { sign: "■", words: "locked", button: "Lock" },
};

export function marksOf(points: readonly BreakPoint[]): BreakMarks {
  const marks = { entering: new Map<string, BreakKind>(), leaving: new Map<string, BreakKind>(), arrows: new Map<string, BreakKind>() };
  for (const point of points) {
    const { from_state: from, to_state: to } = point;
    const kind = kindOf(point);
    if (!kind) continue;
    const [marked, key] = !from ? [marks.entering, to] : !to ? [marks.leaving, from] : [marks.arrows, `${from} → ${to}`];
    marked.set(key, kind);
  }
  return marks;
}

/** For who hears the graph: "entering it stops the robot, leaving it is locked"; empty: nothing is there. */
export function stateMarkWords({ entering, leaving }: BreakMarks, state: string): string {
  const words = (kind: BreakKind) => (kind === "lock" ? "is locked" : BREAK_KINDS[kind].words);
  const [enters, leaves] = [entering.get(state), leaving.get(state)];
  return [enters && `entering it ${words(enters)}`, leaves && `leaving it ${words(leaves)}`].filter(Boolean).join(", ");
}
