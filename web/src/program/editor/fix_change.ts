// SPDX-License-Identifier: BSD-3-Clause
import type { ChangeSpec, Text } from "@codemirror/state";
import type { Fix } from "./quick_fixes";

/** Where a place is in a text; the nearest that there is. Lines and columns count from 1. */
export function offsetOf(doc: Text, { line, column }: { line: number; column: number }): number {
  const at = doc.line(Math.min(Math.max(line, 1), doc.lines));
  return Math.min(at.from + Math.max(column - 1, 0), at.to);
}

/** What the fix changes, or undefined in another text than its own: somebody edits, and the next problems bring the next fix. */
export function changeOf(fix: Fix, doc: Text): ChangeSpec | undefined {
  if (doc.toString() !== fix.of) return undefined;
  return { from: offsetOf(doc, fix.from), to: offsetOf(doc, fix.to), insert: fix.text };
}
