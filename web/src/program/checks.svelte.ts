import type { Diagnostic } from "../feed/messages";
import * as api from "../feed/api";
import { withKnownFixes } from "./editor/quick_fixes";
import { live } from "../model/live.svelte";
import type { Bench } from "./bench.svelte";

/** What the monitor and the language server say of the program on the bench. */
export class Checks {
  result = $state.raw<api.CheckResult>();
  /** The text that `result` speaks of. */
  #checked = $state("");
  /** What the language server says of each file as one types. */
  #typed = $state.raw<ReadonlyMap<string, readonly Diagnostic[]>>(new Map());

  constructor(private readonly bench: Bench) {}

  readonly #text: string = $derived.by(() => JSON.stringify(this.bench.files));
  readonly isChecked: boolean = $derived(this.#checked === this.#text && this.result !== undefined);
  readonly #problemsTyped: Diagnostic[] = $derived.by(() => this.bench.files.flatMap(({ path }) => this.#typed.get(path) ?? []));
  readonly diagnostics: Diagnostic[] = $derived(
    this.isChecked ? withKnownFixes(this.result?.diagnostics ?? [], this.#problemsTyped) : this.#problemsTyped,
  );
  readonly errors: Diagnostic[] = $derived(this.diagnostics.filter(({ severity }) => severity === "error"));

  /** What comes of it is kept if nobody has typed on meanwhile. */
  async examine(): Promise<void> {
    const text = this.#text;
    const result = await api.check(this.bench.files, live.robot?.name, live.robot?.program?.value.files);
    if (text !== this.#text) return;
    this.result = result;
    this.#checked = text;
  }

  refused(diagnostics: readonly Diagnostic[]): void {
    this.result = { ok: false, hash: "", diagnostics: [...diagnostics] };
    this.#checked = this.#text;
  }

  forget(): void {
    this.result = undefined;
  }

  noteProblems(path: string, problems: readonly Diagnostic[]): void {
    this.#typed = new Map(this.#typed).set(path, problems);
  }

  forgetProblems(): void {
    this.#typed = new Map();
  }
}
