// Programs as the page works on them: chosen or edited on the bench, checked by the monitor, pushed to robots.

import type { SourceFile } from "../feed/messages";
import * as api from "../feed/api";
import { Attempts } from "../lib/attempts.svelte";
import { live } from "../model/live.svelte";
import { Bench, type Place } from "./bench.svelte";
import { Checks } from "./checks.svelte";
import { Library } from "./library.svelte";
import { Pushing } from "./pushing.svelte";
import { ui } from "../lib/ui.svelte";

export class Workshop {
  readonly attempts = new Attempts();
  readonly library = new Library();
  readonly bench = new Bench();
  readonly checks = new Checks(this.bench);
  readonly pushing = new Pushing(this.bench);

  async list(): Promise<void> {
    await this.attempts.make(() => this.library.list());
  }

  /** A shipped program by its name, or one pushed before by its hash. */
  async choose(key: string): Promise<void> {
    this.bench.chosen = key;
    this.pushing.asking = undefined;
    await this.attempts.make(async () => this.#take(await this.library.read(key)));
  }

  /** Puts what a robot runs on the bench. */
  takeRunning(): void {
    const program = live.robot?.program?.value;
    if (!program) return;
    this.bench.chosen = "";
    this.#take(program.files);
  }

  /** Puts files on the bench that somebody changed elsewhere on the page, and shows the one that is changed. */
  takeChanged(files: readonly SourceFile[], changed: number): void {
    this.bench.chosen = "";
    this.#take(files);
    this.bench.open = changed;
    this.bench.edited = true;
  }

  /** Shows a place of the program that runs, or of the one with that hash; what somebody edits stays on the bench. */
  async showRunning(place: Place, hash = live.robot?.program?.value.hash): Promise<void> {
    if (!this.bench.edited) await this.#takeByHash(hash);
    this.show(place);
  }

  /** The program that a robot runs, or one that ran before and was pushed through the monitor. */
  async #takeByHash(hash: string | undefined): Promise<void> {
    const running = live.robots.find(({ program }) => program?.value.hash === hash)?.program?.value;
    const files = running?.files ?? (hash ? await api.readPushed(hash).catch(() => undefined) : undefined);
    this.bench.chosen = "";
    if (files) this.#take(files);
    else this.takeRunning();
  }

  show(place: Place): void {
    this.bench.show(place);
    ui.editorOpen = true;
  }

  /** As `check`, unasked while one types: says nothing where the monitor does not answer. */
  async preview(): Promise<void> {
    if (this.bench.files.length > 0 && !this.checks.isChecked && !this.attempts.busy) await this.checks.examine().catch(() => {});
  }

  async check(): Promise<void> {
    if (this.bench.files.length > 0) await this.attempts.make(() => this.checks.examine());
  }

  /** Checks, then asks for the one confirming click. */
  async ask(targets: string[]): Promise<void> {
    await this.check();
    if (this.checks.isChecked) this.pushing.asking = targets;
  }

  async push(): Promise<void> {
    const targets = this.pushing.asking;
    if (!targets) return;
    this.pushing.asking = undefined;
    await this.attempts.make(() => this.#withDiagnostics(this.pushing.push(targets)));
    await this.library.refreshHistory();
  }

  /** Puts a program that was pushed before on the bench and asks for the one confirming click. */
  async restore(hash: string): Promise<void> {
    await this.choose(hash);
    if (this.attempts.failure === undefined) await this.ask([]);
  }

  async goBack(id: string, pushedHash: string): Promise<void> {
    await this.attempts.make(() => this.#withDiagnostics(this.pushing.goBack(id, pushedHash)));
  }

  async cancel(id: string): Promise<void> {
    await this.attempts.make(async () => void (await api.cancelPush(id)));
  }

  #take(files: readonly SourceFile[]): void {
    this.bench.take(files);
    this.checks.forget();
  }

  async #withDiagnostics(push: Promise<void>): Promise<void> {
    await push.catch((error: unknown) => {
      if (error instanceof api.Refusal && error.diagnostics.length) this.checks.refused(error.diagnostics);
      throw error;
    });
  }
}

export const workshop = new Workshop();
