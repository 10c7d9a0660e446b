// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the running program that are moved by hand: each goes the way of every push, as soon as the hand rests.

import type { Catalog } from "../bhdl/catalog";
import type { Reply } from "../feed/api";
import * as api from "../feed/api";
import type { SourceFile } from "../feed/messages";
import { live } from "../model/live.svelte";
import { isSilent } from "../model/silence";
import { runningHash, runningProgram } from "../program/running";
import { takeFromDraft, writeToDraft } from "./draft_numbers";
import { ProbationWatch } from "./probation_watch";
import { numberText, type Tunable, tunablesIn, withNumbers } from "./tunables";

const REST_MS = 400;
const ASK_AGAIN_MS = 250;
/** A push that takes longer is left to the panel Program. */
const LONGEST_MS = 60_000;
/** From a robot's answer to its own word of what it runs. */
const TOLD_MS = 3000;

/** What came of a number that was moved. */
export interface Answer {
  readonly pushId: string;
  readonly replies: readonly Reply[];
  /** Why it did not come to the robots at all. */
  readonly failure?: string;
}

interface Move {
  readonly key: string;
  readonly label: string;
  readonly from: number;
  readonly to: number;
}

interface Flight {
  /** Where it goes: answers count only while the sliders are aimed there. */
  readonly target: string;
  readonly moves: readonly Move[];
  readonly numbers: ReadonlyMap<string, number>;
  readonly isUndo: boolean;
}

const pause = (wait_ms: number): Promise<void> => new Promise((resolve) => void setTimeout(resolve, wait_ms));

export class Tuner {
  /** Empty: the team. */
  target = $state("");
  #waiting = $state.raw<ReadonlyMap<string, number>>(new Map());
  #flight = $state.raw<Flight>();
  #answers = $state.raw<ReadonlyMap<string, Answer>>(new Map());
  #done = $state.raw<readonly Move[]>([]);
  #waitsForUndo = false;
  /** What came to the robots and is not confirmed: they go back from all of it at once. */
  #onProbation: readonly Move[] = [];
  #probation: ProbationWatch | undefined;
  #rest: ReturnType<typeof setTimeout> | undefined;

  /** Of the team those that are in service and heard: nobody knows what a silent robot runs, and it would not answer; nor would one of a recording. */
  readonly reached: readonly string[] = $derived.by(() => {
    if (this.target) return [this.target];
    const robots = [...live.present.robots.values()];
    return robots.filter((robot) => !robot.state?.value.out_of_service && !live.present.replayed.has(robot.name) && !isSilent(robot, live.known_present_ms)).map(({ name }) => name);
  });
  /** Whom a push names: nobody where it reaches the whole team. */
  readonly targets: readonly string[] = $derived.by(() => (!this.target && this.reached.length === live.present.robots.size ? [] : this.reached));
  /** What the robots run; undefined where they do not run the same, or none is reached: then no one program is changed. */
  readonly program = $derived.by(() => (this.reached.length > 0 && runningHash(this.targets) ? runningProgram(this.targets) : undefined));
  readonly catalog = $derived.by(() => live.present.robots.get(this.reached[0] ?? "")?.catalog);
  readonly tunables: readonly Tunable[] = $derived(this.program && this.catalog ? tunablesIn(this.program.files, this.catalog) : []);

  get isBusy(): boolean {
    return this.#flight !== undefined || this.#waiting.size > 0;
  }

  /** The move that undo would take back. */
  get last(): Move | undefined {
    return this.#done.at(-1);
  }

  /** Where the slider stands: where the hand put it until the robots have answered, and then where they run it. */
  valueOf({ key, value }: Tunable): number {
    return this.#waiting.get(key) ?? this.#flightHere?.numbers.get(key) ?? value;
  }

  isUnderWay(key: string): boolean {
    return this.#waiting.has(key) || this.#flightHere?.numbers.has(key) === true;
  }

  get #flightHere(): Flight | undefined {
    return this.#flight?.target === this.target ? this.#flight : undefined;
  }

  answerOf(key: string): Answer | undefined {
    return this.#answers.get(key);
  }

  /** The hand moves a number. What it rests at counts. */
  move({ key }: Pick<Tunable, "key">, value: number): void {
    this.#waitsForUndo = false;
    this.#wait(key, value);
  }

  /** Takes the last move back that came to the robots. */
  undo(): void {
    const { last } = this;
    if (!last || this.isBusy) return;
    this.#waitsForUndo = true;
    this.#wait(last.key, last.from);
  }

  /** Of another robot nothing is known yet. */
  aim(target: string): void {
    clearTimeout(this.#rest);
    this.#rest = undefined;
    this.target = target;
    this.#waiting = new Map();
    this.#answers = new Map();
    this.#done = [];
  }

  #wait(key: string, value: number): void {
    this.#waiting = new Map(this.#waiting).set(key, value);
    clearTimeout(this.#rest);
    this.#rest = setTimeout(() => {
      this.#rest = undefined;
      void this.#send();
    }, REST_MS);
  }

  async #send(): Promise<void> {
    const { program, catalog, targets } = this;
    // While the hand moves, what it rests at is sent by and by.
    if (this.#flight || this.#rest !== undefined || this.#waiting.size === 0) return;
    const moves = this.#movesOf(this.#waiting);
    const flight: Flight = { target: this.target, moves, numbers: this.#waiting, isUndo: this.#waitsForUndo };
    [this.#flight, this.#waiting, this.#waitsForUndo] = [flight, new Map(), false];
    try {
      if (!program || !catalog) throw new Error("It is not known what the robots run.");
      if (moves.length > 0) await this.#push(flight, withNumbers(program.files, catalog, flight.numbers, flight.isUndo), targets, program.hash);
    } catch (error) {
      this.#answer(flight, { pushId: "", replies: [], failure: (error as Error).message });
    } finally {
      this.#flight = undefined;
      void this.#send();
    }
  }

  #movesOf(numbers: ReadonlyMap<string, number>): Move[] {
    return this.tunables.flatMap(({ key, schema, label, value: from }) => {
      const to = numbers.get(key);
      return to === undefined || to === from ? [] : [{ key, label: `${schema} · ${label}`, from, to }];
    });
  }

  async #push(flight: Flight, files: readonly SourceFile[], targets: readonly string[], replaces: string): Promise<void> {
    const { catalog } = this;
    const probation = new ProbationWatch(this.reached);
    const ended = await this.#carry(flight, files, targets, replaces).catch((error: unknown) => (probation.end(), Promise.reject(error)));
    const takers = ended.replies.filter(({ status }) => status === "running" || status === "confirmed").map(({ robot }) => robot);
    if (takers.length === 0) return probation.end();
    await this.#told(ended.hash, targets);
    if (flight.target === this.target) this.#done = flight.isUndo ? this.#done.slice(0, -1) : [...this.#done, ...flight.moves];
    if (!catalog) return probation.end();
    writeToDraft(files, catalog, flight.numbers);
    // It has taken the place of the push before it.
    this.#probation?.end();
    this.#probation = probation;
    this.#onProbation = [...this.#onProbation, ...flight.moves];
    void probation.outcome(ended.id, takers).then((isKept) => this.#judged(isKept, ended.hash, takers, catalog));
  }

  /** Sends it, and answers what came of it at each step. */
  async #carry(flight: Flight, files: readonly SourceFile[], targets: readonly string[], replaces: string): Promise<api.PushResult> {
    const begun = await api.push(files, targets, { replaces, reason: this.#reasonOf(flight.moves) });
    live.pushed(begun, files, targets);
    this.#answer(flight, { pushId: begun.id, replies: begun.replies });
    const ended = await this.#ended(begun);
    live.pushed(ended, files, targets);
    this.#answer(flight, { pushId: ended.id, replies: ended.replies });
    return ended;
  }

  /** The robots keep what is on probation, or each of them has gone back from it: then the draft does, too. */
  async #judged(isKept: boolean, hash: string, robots: readonly string[], catalog: Catalog): Promise<void> {
    const moves = this.#onProbation;
    this.#onProbation = [];
    if (isKept) return;
    this.#done = this.#done.filter((move) => !moves.includes(move));
    await this.#until(() => runningHash(robots) !== hash && runningProgram(robots)?.hash === runningHash(robots));
    const running = runningProgram(robots);
    if (running && running.hash !== hash) takeFromDraft(running.files, catalog, new Map(moves.map(({ key, to }) => [key, to])));
  }

  async #ended(begun: api.PushResult): Promise<api.PushResult> {
    const until_ms = Date.now() + LONGEST_MS;
    let result = begun;
    while (result.state === "running" && Date.now() < until_ms) {
      await pause(ASK_AGAIN_MS);
      result = await api.readPush(begun.id);
    }
    return result;
  }

  /** Until the robots say themselves what they run: the next number is put into that. */
  #told(hash: string, targets: readonly string[]): Promise<void> {
    return this.#until(() => runningHash(targets) === hash && runningProgram(targets)?.hash === hash);
  }

  async #until(isTold: () => boolean): Promise<void> {
    const until_ms = Date.now() + TOLD_MS;
    while (Date.now() < until_ms && !isTold()) await pause(50);
  }

  #answer({ target, moves }: Flight, answer: Answer): void {
    if (target !== this.target) return;
    const answers = new Map(this.#answers);
    for (const { key } of moves) answers.set(key, answer);
    this.#answers = answers;
  }

  /** As it stands in the history, beside who pushed it. */
  #reasonOf(moves: readonly Move[]): string {
    const steps = new Map(this.tunables.map(({ key, step }) => [key, step]));
    const text = (key: string, value: number) => numberText(value, steps.get(key) ?? 1e-6);
    return moves.map(({ key, label, from, to }) => `${label} ${from} → ${text(key, to)}`).join(", ");
  }
}

export const tuner = new Tuner();
