import type { SourceFile } from "../feed/messages";

export interface Place {
  file: string;
  line: number;
  column: number;
}

/** The program that is looked at and edited. */
export class Bench {
  chosen = $state("");
  files = $state<SourceFile[]>([]);
  open = $state(0);
  /** Somebody changed what was chosen. */
  edited = $state(false);
  /** Grows when other files come onto the bench. */
  generation = $state(0);
  /** Where the editor is to show its cursor. */
  place = $state.raw<Place>();

  take(files: readonly SourceFile[]): void {
    this.generation += 1;
    this.edited = false;
    this.files = files.map((file) => ({ ...file }));
    this.open = 0;
    this.place = undefined;
  }

  edit(text: string): void {
    const file = this.files[this.open];
    if (!file || file.text === text) return;
    this.edited = true;
    this.files[this.open] = { ...file, text };
  }

  /** A change that was made elsewhere than in the editor: by renaming. */
  editFile(path: string, text: string): void {
    const index = this.files.findIndex((file) => file.path === path);
    if (index < 0 || this.files[index]?.text === text) return;
    this.edited = true;
    this.files[index] = { path, text };
  }

  show(place: Place): void {
    const open = this.files.findIndex((file) => file.path === place.file);
    if (open >= 0) this.open = open;
    this.place = place;
  }
}
