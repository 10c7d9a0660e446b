// SPDX-License-Identifier: BSD-3-Clause
import type { Diagnostic, Program } from "../feed/messages";
import type { Machine } from "../feed/parts";
import * as api from "../feed/api";
import { Latest } from "../lib/latest";
import { type FixableDiagnostic, withKnownFixes } from "./editor/quick_fixes";
import { live } from "../model/live.svelte";
import type { Bench } from "./bench.svelte";
import type { Draft } from "./draft";
import { TypedProblems } from "./typed_problems.svelte";

/** What the monitor says of one draft. */
interface Verdict {
  readonly draft: Draft;
  readonly result: api.CheckResult;
  /** The program that it was compared with. */
  readonly against?: Program;
}

/** What the monitor and the language server say of the program on the bench. */
export class Checks {
  #verdict = $state.raw<Verdict>();
  #drawn = $state.raw<{ readonly generation: number; readonly machine: Machine }>();
  #unanswered = $state.raw<Draft>();
  #asked = new Latest();
  readonly typed: TypedProblems;

  constructor(private readonly bench: Bench) {
    this.typed = new TypedProblems(bench);
  }

  readonly #current: Verdict | undefined = $derived.by(() => (this.#verdict?.draft === this.bench.draft ? this.#verdict : undefined));
  readonly #isComparedWithRunning: boolean = $derived(this.#current?.against?.hash === live.presentRobot?.program?.value.hash);
  readonly diagnostics: FixableDiagnostic[] = $derived.by(() =>
    this.verdict ? withKnownFixes(this.verdict.diagnostics, this.typed.problems) : this.typed.problems,
  );
  readonly errors: FixableDiagnostic[] = $derived(this.diagnostics.filter(({ severity }) => severity === "error"));

  /** What the monitor says of the text as it stands; undefined until it was asked. */
  get verdict(): api.CheckResult | undefined {
    return this.#current?.result;
  }

  /** What the program tells a robot otherwise than the one that the chosen robot runs, in words. */
  get changes(): readonly string[] | undefined {
    return this.#isComparedWithRunning ? this.verdict?.changes : undefined;
  }

  /** Of the last text of this program that had no errors. */
  get machine(): Machine | undefined {
    return this.#drawn?.generation === this.bench.generation ? this.#drawn.machine : undefined;
  }

  /** The monitor was asked about the text as it stands, and compared it with what runs now. */
  get isUpToDate(): boolean {
    return this.#current !== undefined && this.#isComparedWithRunning;
  }

  /** The monitor was asked about the text as it stands, and could not be reached or gave no answer. */
  get isUnanswered(): boolean {
    return this.#unanswered === this.bench.draft;
  }

  /** Asks the monitor. Its answer counts unless the text changes, or it is asked again, before it comes. */
  async examine(): Promise<void> {
    const { draft } = this.bench;
    const against = live.presentRobot?.program?.value;
    const answer = api.check(draft.files, live.robot?.name, against?.files);
    answer.then(
      () => (this.#unanswered = undefined),
      () => (this.#unanswered = draft),
    );
    await this.#asked.take(answer, (result) => this.#note({ draft, result, against }));
  }

  /** The monitor refused to push a draft, which may have left the bench since. */
  refused(draft: Draft, diagnostics: readonly Diagnostic[]): void {
    this.#note({ draft, result: { ok: false, hash: "", diagnostics: [...diagnostics] } });
  }

  #note(verdict: Verdict): void {
    if (verdict.draft !== this.bench.draft) return;
    this.#verdict = verdict;
    const { machine } = verdict.result;
    if (machine) this.#drawn = { generation: this.bench.generation, machine };
  }
}
