// The program on the bench: chosen or edited here, checked by the monitor, pushed to robots.

import type { Diagnostic, SourceFile } from "./feed/messages";
import * as api from "./lib/api";
import { live } from "./live.svelte";
import { ui } from "./ui.svelte";

export interface Place {
  file: string;
  line: number;
  column: number;
}

class Workshop {
  entries = $state<api.ProgramEntry[]>([]);
  chosen = $state("");
  files = $state<SourceFile[]>([]);
  open = $state(0);
  result = $state.raw<api.CheckResult>();
  /** Grows when other files come onto the bench. */
  generation = $state(0);
  /** The text that `result` speaks of. */
  #checked = $state("");
  /** Whom a push would go to; undefined: none is being asked about. */
  asking = $state<string[]>();
  busy = $state(false);
  failure = $state<string>();
  /** Where the editor is to show its cursor. */
  place = $state.raw<Place>();

  readonly #text: string = $derived(JSON.stringify(this.files));
  readonly isChecked: boolean = $derived(this.#checked === this.#text && this.result !== undefined);
  readonly diagnostics: Diagnostic[] = $derived(this.isChecked ? (this.result?.diagnostics ?? []) : []);
  readonly errors: Diagnostic[] = $derived(this.diagnostics.filter(({ severity }) => severity === "error"));

  async list(): Promise<void> {
    await this.#during(async () => {
      this.entries = await api.listPrograms();
    });
  }

  async choose(name: string): Promise<void> {
    this.chosen = name;
    this.asking = undefined;
    await this.#during(async () => this.#take(await api.readProgram(name)));
  }

  /** Puts what a robot runs on the bench. */
  takeRunning(): void {
    const program = live.robot?.program?.value;
    if (!program) return;
    this.chosen = this.entries.some((entry) => entry.name === program.name) ? program.name : "";
    this.#take(program.files);
  }

  edit(text: string): void {
    const file = this.files[this.open];
    if (file && file.text !== text) this.files[this.open] = { ...file, text };
  }

  show(place: Place): void {
    const open = this.files.findIndex((file) => file.path === place.file);
    if (open >= 0) this.open = open;
    this.place = place;
    ui.editorOpen = true;
  }

  async check(): Promise<boolean> {
    if (this.files.length === 0) return false;
    const text = this.#text;
    await this.#during(async () => {
      this.result = await api.check(this.files, live.robot?.name);
      this.#checked = text;
    });
    return this.isChecked && this.result?.ok === true;
  }

  /** Checks, then asks for the one confirming click. A program with errors may be sent: the robots refuse it. */
  async ask(targets: string[]): Promise<void> {
    await this.check();
    if (this.isChecked) this.asking = targets;
  }

  async push(): Promise<void> {
    const targets = this.asking;
    if (!targets) return;
    this.asking = undefined;
    await this.#during(async () => live.pushed(await api.push(this.files, targets), this.files, targets));
  }

  #take(files: readonly SourceFile[]): void {
    this.generation += 1;
    this.files = files.map((file) => ({ ...file }));
    this.open = 0;
    this.result = undefined;
    this.place = undefined;
  }

  async #during(work: () => Promise<void>): Promise<void> {
    this.busy = true;
    this.failure = undefined;
    try {
      await work();
    } catch (error) {
      this.failure = (error as Error).message;
    } finally {
      this.busy = false;
    }
  }
}

export const workshop = new Workshop();
