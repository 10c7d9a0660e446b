// SPDX-License-Identifier: BSD-3-Clause
import type { SourceFile } from "../feed/messages";
import * as api from "../feed/api";
import { Latest } from "../lib/latest";

/** The programs that the monitor knows: those that ship, and all that were pushed. */
export class Library {
  shipped = $state.raw<readonly api.ProgramEntry[]>([]);
  /** Every push, the newest first, as the monitor took them: senders' clocks say nothing of that. */
  history = $state.raw<readonly api.PushedProgram[]>([]);
  /** Programs that were pushed before, the newest first, each once. */
  readonly pushed: api.PushedProgram[] = $derived(eachOnce(this.history));
  #shippedLists = new Latest();
  #histories = new Latest();

  async list(): Promise<void> {
    await Promise.all([this.#shippedLists.take(api.listPrograms(), (all) => (this.shipped = all)), this.#listPushed()]);
  }

  /** Leaves what is known where the monitor does not answer. */
  async refreshHistory(): Promise<void> {
    await this.#listPushed().catch(() => {});
  }

  /** The files of a shipped program by its name, or of one pushed before by its hash. */
  read(key: string): Promise<SourceFile[]> {
    return this.pushed.some(({ hash }) => hash === key) ? api.readPushed(key) : api.readProgram(key);
  }

  async #listPushed(): Promise<void> {
    await this.#histories.take(api.listPushed(), (all) => (this.history = all));
  }
}

function eachOnce(pushes: readonly api.PushedProgram[]): api.PushedProgram[] {
  return pushes.filter(({ hash }, i) => hash && pushes.findIndex((other) => other.hash === hash) === i);
}
