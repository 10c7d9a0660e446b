// SPDX-License-Identifier: BSD-3-Clause
import type { BreakMarks } from "./break_marks";
import type { MachineCounts } from "./machine_counts";

/** What a machine's states and arrows show besides themselves, and whom they tell of hand and pointer. */
export interface MachineParts {
  readonly current: string | undefined;
  /** How lately a transition fired, by "from → to": 1 just now, 0 long ago. */
  readonly fired: ReadonlyMap<string, number>;
  /** Transitions that are near to firing. */
  readonly near: ReadonlySet<string>;
  /** A state's name, or "from → to". */
  readonly chosen: string | undefined;
  readonly marks: BreakMarks;
  /** The locked transition that only waits to be let through. */
  readonly waits: string | undefined;
  /** How often what happened; what never did is drawn hollow. */
  readonly counts: MachineCounts | undefined;
  readonly choose: (what: string, by: MouseEvent | KeyboardEvent) => void;
  /** What the pointer or the keyboard is at. */
  readonly point: (what: string | undefined) => void;
}
