// SPDX-License-Identifier: BSD-3-Clause
import type { SourceFile } from "../feed/messages";
import * as api from "../feed/api";
import { Latest } from "../lib/latest";
import { live } from "../model/live.svelte";
import type { Bench } from "./bench.svelte";
import type { Checks } from "./checks.svelte";
import type { Draft } from "./draft";
import { runningHash, runningProgram } from "./running";

/** Whether to push this draft, which was checked, to these robots. Empty `targets` mean the whole team. */
export interface Question {
  readonly draft: Draft;
  /** Of the program; empty if it has errors. */
  readonly hash: string;
  readonly targets: readonly string[];
}

/** How the program on the bench comes to robots, and how they come back to what ran before. */
export class Pushing {
  #question = $state.raw<Question>();
  /** From the confirming click on, until somebody closes the answers. */
  #isFollowed = $state(false);
  #checks = new Latest();
  /** The way that the next push takes. */
  tries = $state(false);
  canary = $state("");
  probation_s = $state(10);

  /** What ran before a push of this page, for going back. */
  #before = new Map<string, { files: readonly SourceFile[]; targets: readonly string[] }>();

  constructor(
    private readonly bench: Bench,
    private readonly checks: Checks,
  ) {}

  /** What waits for the one confirming click. It is withdrawn when what stands on the bench is no longer what it is about. */
  get question(): Question | undefined {
    return this.#question?.draft === this.bench.draft ? this.#question : undefined;
  }

  /** Whether there is a question or are answers that somebody should look at. */
  get isShown(): boolean {
    return this.question !== undefined || this.#isFollowed;
  }

  close(): void {
    this.withdraw();
    this.#isFollowed = false;
  }

  /** Puts the question once `check` has come to its end, unless the bench has another text by then. */
  async ask(targets: readonly string[], check: Promise<void>): Promise<void> {
    this.withdraw();
    const { draft } = this.bench;
    await this.#checks.take(check, () => {
      const { verdict } = this.checks;
      if (verdict && draft === this.bench.draft) this.#question = { draft, hash: verdict.hash, targets };
    });
  }

  /** Also of a question that is yet to be put. */
  withdraw(): void {
    this.#checks.supersede();
    this.#question = undefined;
  }

  /** Pushes what was asked about. */
  async confirm({ draft, targets }: Question): Promise<void> {
    this.withdraw();
    this.#isFollowed = true;
    const canary = this.canary !== "" && targets.length !== 1 ? this.canary : "";
    const way = { tries: this.tries, canary, probation_s: this.probation_s, replaces: runningHash(targets) };
    try {
      await this.#send(draft.files, targets, way);
    } catch (error) {
      if (error instanceof api.Refusal && error.diagnostics.length) this.checks.refused(draft, error.diagnostics);
      throw error;
    }
  }

  canGoBack(id: string): boolean {
    return this.#before.has(id);
  }

  /** Pushes what ran before; refused where somebody else has pushed since. */
  async goBack(id: string, pushedHash: string): Promise<void> {
    const before = this.#before.get(id);
    if (before) await this.#send(before.files, before.targets, { replaces: pushedHash });
  }

  async #send(files: readonly SourceFile[], targets: readonly string[], way: api.PushWay): Promise<void> {
    const running = runningProgram(targets);
    const result = await api.push(files, targets, way);
    if (running && running.hash !== result.hash) this.#before.set(result.id, { files: running.files, targets });
    live.pushed(result, files, targets);
  }
}
