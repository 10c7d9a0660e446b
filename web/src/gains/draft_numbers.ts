// SPDX-License-Identifier: BSD-3-Clause
import type { Catalog } from "../bhdl/catalog";
import type { SourceFile } from "../feed/messages";
import { ui } from "../lib/ui.svelte";
import { live } from "../model/live.svelte";
import { workshop } from "../program/workshop.svelte";
import { numberText, type Tunable, tunablesIn, withNumbers } from "./tunables";

/** The draft as numbers were last written into it: where it stands so, nobody has typed since. */
let written: readonly SourceFile[] | undefined;

function isTypedIn(): boolean {
  const { draft } = workshop.bench;
  return ui.editorOpen && draft.edited && draft.files !== written;
}

function put(files: readonly SourceFile[], open: number): void {
  workshop.takeChanged(files, open);
  written = workshop.bench.files;
}

/**
 * Writes numbers that came to the robots into the draft, which keeps every other character; where there is no draft,
 * `files`, which are what was pushed, become it. What somebody types in the open editor, or waits for, is left alone.
 */
export function writeToDraft(files: readonly SourceFile[], catalog: Catalog, numbers: ReadonlyMap<string, number>): void {
  const { bench } = workshop;
  if (bench.isLoading || isTypedIn()) return;
  if (bench.files.length === 0) return put(files, 0);
  const next = withNumbers(bench.files, catalog, numbers);
  if (next.some(({ text }, i) => text !== bench.files[i]!.text)) put(next, bench.open);
}

/**
 * Takes numbers out of the draft that the robots went back from, where they stand as they were written: what `running`
 * has takes their place. What somebody types in the open editor is left alone, and the page says so.
 */
export function takeFromDraft(running: readonly SourceFile[], catalog: Catalog, numbers: ReadonlyMap<string, number>): void {
  const { bench } = workshop;
  if (bench.isLoading) return;
  const values = new Map(tunablesIn(running, catalog).map(({ key, value }) => [key, value]));
  const isWritten = ({ key, value, step }: Tunable) => numbers.has(key) && numberText(numbers.get(key)!, step) === numberText(value, step);
  const gone = tunablesIn(bench.files, catalog).filter((each) => isWritten(each) && values.has(each.key) && values.get(each.key) !== each.value);
  if (gone.length === 0) return;
  if (!isTypedIn()) return put(withNumbers(bench.files, catalog, new Map(gone.map(({ key }) => [key, values.get(key)!])), true), bench.open);
  const words = gone.map(({ key, schema, label, value }) => `${schema} · ${label} ${value}, where the robots run ${values.get(key)}`);
  live.trouble = `The robots went back. The draft still has ${words.join("; ")}.`;
}
