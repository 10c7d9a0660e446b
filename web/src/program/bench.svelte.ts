// SPDX-License-Identifier: BSD-3-Clause
import type { SourceFile } from "../feed/messages";
import { Latest } from "../lib/latest";
import { type Draft, emptyDraft, withText } from "./draft";

export interface Place {
  file: string;
  line: number;
  column: number;
}

/** The program that is looked at and edited, and the one that is on its way to take its place. */
export class Bench {
  #draft = $state.raw<Draft>(emptyDraft);
  #coming = $state.raw<{ readonly chosen: string }>();
  #choices = new Latest();
  #generation = $state(0);
  /** The index of the file in the editor. */
  open = $state(0);
  /** Where the editor is to show its cursor. */
  place = $state.raw<Place>();

  get draft(): Draft {
    return this.#draft;
  }

  get files(): readonly SourceFile[] {
    return this.#draft.files;
  }

  /** Grows when another program comes onto the bench, and not as one types. */
  get generation(): number {
    return this.#generation;
  }

  get isLoading(): boolean {
    return this.#coming !== undefined;
  }

  /** What somebody chose, even if it is still on its way. */
  get chosen(): string {
    return this.#coming?.chosen ?? this.#draft.chosen;
  }

  put(draft: Draft, open = 0): void {
    this.#expectNothing();
    this.#draft = draft;
    this.#generation += 1;
    this.open = open;
    this.place = undefined;
  }

  /**
   * Puts `files` on the bench when they come. Returns false if something else was put there or chosen meanwhile.
   * Errors: the files do not come, or somebody edits what lies on the bench before they do.
   */
  async load(chosen: string, files: Promise<readonly SourceFile[]>): Promise<boolean> {
    const coming = { chosen };
    this.#coming = coming;
    try {
      return await this.#choices.take(files, (come) => this.put({ chosen, files: come, edited: false }));
    } finally {
      if (this.#coming === coming) this.#coming = undefined;
    }
  }

  edit(path: string, text: string): void {
    const edited = withText(this.#draft, path, text);
    if (edited === this.#draft) return;
    if (this.isLoading)
      this.#expectNothing(new Error("The chosen program was not opened, because the one on the bench was edited meanwhile. Choose it again."));
    this.#draft = edited;
  }

  show(place: Place): void {
    const open = this.files.findIndex((file) => file.path === place.file);
    if (open >= 0) this.open = open;
    this.place = place;
  }

  #expectNothing(why?: Error): void {
    this.#choices.supersede(why);
    this.#coming = undefined;
  }
}
