import type { SourceFile } from "../feed/messages";
import * as api from "../feed/api";
import { live } from "../model/live.svelte";
import type { Bench } from "./bench.svelte";
import { runningHash, runningProgram } from "./running";

/** How the program on the bench comes to robots, and how they come back to what ran before. */
export class Pushing {
  /** Whom a push would go to; undefined: none is being asked about. */
  asking = $state<string[]>();
  /** The way that the next push takes. */
  tries = $state(false);
  canary = $state("");
  probation_s = $state(10);

  /** What ran before a push of this page, for going back. */
  #before = new Map<string, { files: readonly SourceFile[]; targets: readonly string[] }>();

  constructor(private readonly bench: Bench) {}

  async push(targets: readonly string[]): Promise<void> {
    const canary = this.canary !== "" && targets.length !== 1 ? this.canary : "";
    const way = { tries: this.tries, canary, probation_s: this.probation_s, replaces: runningHash(targets) };
    await this.#send(this.bench.files, targets, way);
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
