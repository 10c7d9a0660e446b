// SPDX-License-Identifier: BSD-3-Clause
import type { Catalog } from "../bhdl/catalog";
import type { SourceFile } from "../feed/messages";
import { ui } from "../lib/ui.svelte";
import { workshop } from "../program/workshop.svelte";
import { withNumbers } from "./tunables";

/**
 * Writes numbers that came to the robots into the draft, which keeps every other character; where there is no draft,
 * `files`, which are what was pushed, become it. What somebody types in the open editor, or waits for, is left alone.
 */
export function writeToDraft(files: readonly SourceFile[], catalog: Catalog, numbers: ReadonlyMap<string, number>): void {
  const { bench } = workshop;
  if (bench.isLoading || (ui.editorOpen && bench.draft.edited)) return;
  if (bench.files.length === 0) return workshop.takeChanged(files, 0);
  const next = withNumbers(bench.files, catalog, numbers);
  if (next.some(({ text }, i) => text !== bench.files[i]!.text)) workshop.takeChanged(next, bench.open);
}
