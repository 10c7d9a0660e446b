// SPDX-License-Identifier: BSD-3-Clause
import type { SourceFile } from "../feed/messages";

/** A program on the bench. Its name and its text stand together and never change: what is edited is another draft. */
export interface Draft {
  /** A shipped program's name or the hash of one pushed before; empty: it comes from a robot or from this page. */
  readonly chosen: string;
  /** The main file first, then its includes. */
  readonly files: readonly SourceFile[];
  /** Somebody changed it on this page. */
  readonly edited: boolean;
}

export const emptyDraft: Draft = { chosen: "", files: [], edited: false };

/** The same draft where it has no such file, or has that text. */
export function withText(draft: Draft, path: string, text: string): Draft {
  const file = draft.files.find((each) => each.path === path);
  if (!file || file.text === text) return draft;
  const files = draft.files.map((each) => (each === file ? { path, text } : each));
  return { ...draft, files, edited: true };
}
