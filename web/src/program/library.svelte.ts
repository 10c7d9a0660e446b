import type { SourceFile } from "../feed/messages";
import * as api from "../feed/api";

/** The programs that the monitor knows: those that ship, and all that were pushed. */
export class Library {
  shipped = $state<api.ProgramEntry[]>([]);
  /** Every push, the newest first. */
  history = $state.raw<readonly api.PushedProgram[]>([]);
  /** Programs that were pushed before, the newest first, each once. */
  readonly pushed: api.PushedProgram[] = $derived(eachOnce(this.history));

  async list(): Promise<void> {
    [this.shipped, this.history] = await Promise.all([api.listPrograms(), api.listPushed().then(newestFirst)]);
  }

  async refreshHistory(): Promise<void> {
    await api.listPushed().then((all) => (this.history = newestFirst(all)), () => {});
  }

  /** The files of a shipped program by its name, or of one pushed before by its hash. */
  read(key: string): Promise<SourceFile[]> {
    return this.pushed.some(({ hash }) => hash === key) ? api.readPushed(key) : api.readProgram(key);
  }
}

function newestFirst(pushes: readonly api.PushedProgram[]): api.PushedProgram[] {
  return [...pushes].sort((a, b) => b.pushed_ns - a.pushed_ns);
}

function eachOnce(pushes: readonly api.PushedProgram[]): api.PushedProgram[] {
  return pushes.filter(({ hash }, i) => hash && pushes.findIndex((other) => other.hash === hash) === i);
}
