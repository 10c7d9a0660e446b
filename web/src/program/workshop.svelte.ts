// SPDX-License-Identifier: BSD-3-Clause
// Programs as the page works on them: chosen or edited on the bench, checked by the monitor, pushed to robots.

import type { SourceFile } from "../feed/messages";
import * as api from "../feed/api";
import { Attempts } from "../lib/attempts.svelte";
import { live } from "../model/live.svelte";
import { rights } from "../model/rights.svelte";
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
  readonly pushing = new Pushing(this.bench, this.checks);

  async list(): Promise<void> {
    await this.attempts.make(() => this.library.list());
  }

  /**
   * Puts a shipped program on the bench by its name, or one pushed before by its hash.
   * Returns whether it stands there: not if the monitor refuses, or if something else is chosen or edited meanwhile.
   */
  async choose(key: string): Promise<boolean> {
    this.pushing.withdraw();
    return (await this.attempts.make(() => this.bench.load(key, this.library.read(key)))) === true;
  }

  /** Puts what a robot runs now on the bench, whatever instant is shown. */
  takeRunning(): void {
    const program = live.presentRobot?.program?.value;
    if (program) this.#take(program.files);
  }

  /** Puts files on the bench that somebody changed elsewhere on the page, and shows the one that is changed. */
  takeChanged(files: readonly SourceFile[], changed: number): void {
    this.bench.put({ chosen: "", files, edited: true }, changed);
  }

  /** Shows a place of the program that runs, or of the one with that hash; what somebody edits stays on the bench. */
  async showRunning(place: Place, hash = live.robot?.program?.value.hash): Promise<void> {
    if (this.bench.draft.edited || (await this.#takeByHash(hash))) this.show(place);
  }

  /**
   * Puts the program that a robot runs on the bench, or one that was pushed before, or else what the chosen robot runs.
   * Returns false if something else is chosen meanwhile.
   */
  async #takeByHash(hash: string | undefined): Promise<boolean> {
    const running = [...live.present.robots.values()].find(({ program }) => program?.value.hash === hash)?.program?.value;
    if (running) this.#take(running.files);
    else if (!hash) this.takeRunning();
    // Where somebody types meanwhile, that stays, as everything that is edited does.
    else return this.bench.load("", this.#readPushed(hash)).catch(() => true);
    return true;
  }

  #readPushed(hash: string): Promise<readonly SourceFile[]> {
    return api.readPushed(hash).catch(() => live.robot?.program?.value.files ?? this.bench.files);
  }

  show(place: Place): void {
    this.bench.show(place);
    ui.editorOpen = true;
  }

  /** As `check`, unasked while one types: says nothing where the monitor does not answer. */
  async preview(): Promise<void> {
    if (this.bench.files.length > 0 && !this.checks.isUpToDate && !this.attempts.busy) await this.checks.examine().catch(() => {});
  }

  /** Nothing is checked under the name of a program that is still on its way. */
  get canCheck(): boolean {
    return this.bench.files.length > 0 && !this.bench.isLoading;
  }

  async check(): Promise<void> {
    if (this.canCheck) await this.attempts.make(() => this.checks.examine());
  }

  /** Checks, then asks for the one confirming click. */
  async ask(targets: readonly string[]): Promise<void> {
    if (live.playback && !rights.ask()) return;
    if (this.canCheck) await this.pushing.ask(targets, this.check());
  }

  async push(): Promise<void> {
    const { question } = this.pushing;
    if (!question) return;
    await this.attempts.make(() => this.pushing.confirm(question));
    await this.library.refreshHistory();
  }

  /** Puts a program that was pushed before on the bench and asks for the one confirming click. */
  async restore(hash: string): Promise<void> {
    if (await this.choose(hash)) await this.ask([]);
  }

  async goBack(id: string, pushedHash: string): Promise<void> {
    await this.attempts.make(() => this.pushing.goBack(id, pushedHash));
  }

  async cancel(id: string): Promise<void> {
    await this.attempts.make(() => api.cancelPush(id));
  }

  #take(files: readonly SourceFile[]): void {
    this.bench.put({ chosen: "", files, edited: false });
  }
}

export const workshop = new Workshop();
