// SPDX-License-Identifier: BSD-3-Clause
import type { FixableDiagnostic } from "./editor/quick_fixes";
import type { Bench } from "./bench.svelte";

interface Told {
  readonly generation: number;
  readonly text: string | undefined;
  readonly problems: readonly FixableDiagnostic[];
}

/** What the language server says of each file on the bench as somebody types. */
export class TypedProblems {
  #told = $state.raw<ReadonlyMap<string, Told>>(new Map());

  constructor(private readonly bench: Bench) {}

  readonly problems: FixableDiagnostic[] = $derived.by(() => this.bench.files.flatMap(({ path }) => this.#of(path)));

  note(path: string, problems: readonly FixableDiagnostic[]): void {
    this.#told = new Map(this.#told).set(path, { generation: this.bench.generation, text: this.#textOf(path), problems });
  }

  forget(): void {
    this.#told = new Map();
  }

  /** While one types, the last ones stand until the next come; those of another program's file of that name do not. */
  #of(path: string): readonly FixableDiagnostic[] {
    const told = this.#told.get(path);
    const applies = told?.generation === this.bench.generation || told?.text === this.#textOf(path);
    return told && applies ? told.problems : [];
  }

  #textOf(path: string): string | undefined {
    return this.bench.files.find((file) => file.path === path)?.text;
  }
}
