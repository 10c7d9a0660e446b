// The program on the bench: chosen or edited here, checked by the monitor, pushed to robots.

import type { Diagnostic, SourceFile } from "../feed/messages";
import * as api from "../feed/api";
import { withKnownFixes } from "./editor/quick_fixes";
import { live } from "../model/live.svelte";
import { ui } from "../lib/ui.svelte";

export interface Place {
  file: string;
  line: number;
  column: number;
}

class Workshop {
  shipped = $state<api.ProgramEntry[]>([]);
  /** Every push, the newest first. */
  history = $state.raw<readonly api.PushedProgram[]>([]);
  /** Programs that were pushed before, the newest first, each once. */
  readonly pushed: api.PushedProgram[] = $derived(eachOnce(this.history));
  chosen = $state("");
  files = $state<SourceFile[]>([]);
  open = $state(0);
  result = $state.raw<api.CheckResult>();
  /** Somebody changed what was chosen. */
  edited = $state(false);
  /** Grows when other files come onto the bench. */
  generation = $state(0);
  /** The text that `result` speaks of. */
  #checked = $state("");
  /** Whom a push would go to; undefined: none is being asked about. */
  asking = $state<string[]>();
  /** The way that the next push takes. */
  tries = $state(false);
  canary = $state("");
  probation_s = $state(10);
  busy = $state(false);
  failure = $state<string>();
  /** Where the editor is to show its cursor. */
  place = $state.raw<Place>();

  /** What ran before a push of this page, for going back. */
  #before = new Map<string, { files: readonly SourceFile[]; targets: readonly string[] }>();

  readonly #text: string = $derived(JSON.stringify(this.files));
  readonly isChecked: boolean = $derived(this.#checked === this.#text && this.result !== undefined);
  /** What the language server says of each file as one types. */
  #typed = $state.raw<ReadonlyMap<string, readonly Diagnostic[]>>(new Map());
  readonly #problemsTyped: Diagnostic[] = $derived(this.files.flatMap(({ path }) => this.#typed.get(path) ?? []));
  readonly diagnostics: Diagnostic[] = $derived(
    this.isChecked ? withKnownFixes(this.result?.diagnostics ?? [], this.#problemsTyped) : this.#problemsTyped,
  );
  readonly errors: Diagnostic[] = $derived(this.diagnostics.filter(({ severity }) => severity === "error"));

  async list(): Promise<void> {
    await this.#during(async () => {
      [this.shipped, this.history] = await Promise.all([api.listPrograms(), api.listPushed().then(newestFirst)]);
    });
  }

  /** A shipped program by its name, or one pushed before by its hash. */
  async choose(key: string): Promise<void> {
    this.chosen = key;
    this.asking = undefined;
    const before = this.pushed.some(({ hash }) => hash === key);
    await this.#during(async () => this.#take(await (before ? api.readPushed(key) : api.readProgram(key))));
  }

  /** Puts what a robot runs on the bench. */
  takeRunning(): void {
    const program = live.robot?.program?.value;
    if (!program) return;
    this.chosen = "";
    this.#take(program.files);
  }

  /** Puts files on the bench that somebody changed elsewhere on the page, and shows the one that is changed. */
  takeChanged(files: readonly SourceFile[], changed: number): void {
    this.chosen = "";
    this.#take(files);
    this.open = changed;
    this.edited = true;
  }

  edit(text: string): void {
    const file = this.files[this.open];
    if (!file || file.text === text) return;
    this.edited = true;
    this.files[this.open] = { ...file, text };
  }

  /** A change that was made elsewhere than in the editor: by renaming. */
  editFile(path: string, text: string): void {
    const index = this.files.findIndex((file) => file.path === path);
    if (index < 0 || this.files[index]?.text === text) return;
    this.edited = true;
    this.files[index] = { path, text };
  }

  noteProblems(path: string, problems: readonly Diagnostic[]): void {
    this.#typed = new Map(this.#typed).set(path, problems);
  }

  forgetProblems(): void {
    this.#typed = new Map();
  }

  /** Shows a place of the program that runs, or of the one with that hash; what somebody edits stays on the bench. */
  async showRunning(place: Place, hash = live.robot?.program?.value.hash): Promise<void> {
    if (!this.edited) await this.#takeByHash(hash);
    this.show(place);
  }

  /** The program that a robot runs, or one that ran before and was pushed through the monitor. */
  async #takeByHash(hash: string | undefined): Promise<void> {
    const running = live.robots.find(({ program }) => program?.value.hash === hash)?.program?.value;
    const files = running?.files ?? (hash ? await api.readPushed(hash).catch(() => undefined) : undefined);
    this.chosen = "";
    if (files) this.#take(files);
    else this.takeRunning();
  }

  show(place: Place): void {
    const open = this.files.findIndex((file) => file.path === place.file);
    if (open >= 0) this.open = open;
    this.place = place;
    ui.editorOpen = true;
  }

  /** As `check`, unasked while one types: says nothing where the monitor does not answer. */
  async preview(): Promise<void> {
    if (this.files.length > 0 && !this.isChecked && !this.busy) await this.#examine().catch(() => {});
  }

  /** What comes of it is kept if nobody has typed on meanwhile. */
  async #examine(): Promise<void> {
    const text = this.#text;
    const result = await api.check(this.files, live.robot?.name, live.robot?.program?.value.files);
    if (text !== this.#text) return;
    this.result = result;
    this.#checked = text;
  }

  async check(): Promise<boolean> {
    if (this.files.length === 0) return false;
    await this.#during(() => this.#examine());
    return this.isChecked && this.result?.ok === true;
  }

  /** Checks, then asks for the one confirming click. */
  async ask(targets: string[]): Promise<void> {
    await this.check();
    if (this.isChecked) this.asking = targets;
  }

  async push(): Promise<void> {
    const targets = this.asking;
    if (!targets) return;
    this.asking = undefined;
    const canary = this.canary !== "" && targets.length !== 1 ? this.canary : "";
    const way = { tries: this.tries, canary, probation_s: this.probation_s, replaces: runningHash(targets) };
    await this.#during(() => this.#send(this.files, targets, way));
    await this.refreshHistory();
  }

  async refreshHistory(): Promise<void> {
    await api.listPushed().then((all) => (this.history = newestFirst(all)), () => {});
  }

  /** Puts a program that was pushed before on the bench and asks for the one confirming click. */
  async restore(hash: string): Promise<void> {
    await this.choose(hash);
    if (this.failure === undefined) await this.ask([]);
  }

  canGoBack(id: string): boolean {
    return this.#before.has(id);
  }

  /** Pushes what ran before; refused where somebody else has pushed since. */
  async goBack(id: string, pushedHash: string): Promise<void> {
    const before = this.#before.get(id);
    if (before) await this.#during(() => this.#send(before.files, before.targets, { replaces: pushedHash }));
  }

  async cancel(id: string): Promise<void> {
    await this.#during(async () => void (await api.cancelPush(id)));
  }

  async #send(files: readonly SourceFile[], targets: readonly string[], way: api.PushWay): Promise<void> {
    const running = live.present.robots.get(robotsOf(targets)[0] ?? "")?.program?.value;
    const result = await api.push(files, targets, way);
    if (running && running.hash !== result.hash) this.#before.set(result.id, { files: running.files, targets });
    live.pushed(result, files, targets);
  }

  #take(files: readonly SourceFile[]): void {
    this.generation += 1;
    this.edited = false;
    this.files = files.map((file) => ({ ...file }));
    this.open = 0;
    this.result = undefined;
    this.place = undefined;
  }

  #refused(diagnostics: readonly Diagnostic[]): void {
    this.result = { ok: false, hash: "", diagnostics: [...diagnostics] };
    this.#checked = this.#text;
  }

  async #during(work: () => Promise<void>): Promise<void> {
    this.busy = true;
    this.failure = undefined;
    try {
      await work();
    } catch (error) {
      this.failure = (error as Error).message;
      if (error instanceof api.Refusal && error.diagnostics.length) this.#refused(error.diagnostics);
    } finally {
      this.busy = false;
    }
  }
}

function robotsOf(targets: readonly string[]): readonly string[] {
  return targets.length ? targets : live.robots.map(({ name }) => name);
}

/** What all of them run; empty where they differ: then no one program is replaced. */
function runningHash(targets: readonly string[]): string {
  const hashes = new Set(robotsOf(targets).map((name) => live.present.robots.get(name)?.state?.value.program_hash));
  return hashes.size === 1 ? ([...hashes][0] ?? "") : "";
}

function newestFirst(pushes: readonly api.PushedProgram[]): api.PushedProgram[] {
  return [...pushes].sort((a, b) => b.pushed_ns - a.pushed_ns);
}

function eachOnce(pushes: readonly api.PushedProgram[]): api.PushedProgram[] {
  return pushes.filter(({ hash }, i) => hash && pushes.findIndex((other) => other.hash === hash) === i);
}

export const workshop = new Workshop();
