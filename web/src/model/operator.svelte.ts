// SPDX-License-Identifier: BSD-3-Clause
// What the operator tells the robots.

import { type CommandKind, command } from "../feed/api";
import { Attempts } from "../lib/attempts.svelte";
import { live } from "./live.svelte";
import { rights } from "./rights.svelte";
import { type StopProgress, stopProgress } from "./stop_order";

/** Whoever has not confirmed a stop is told again so often. */
const AGAIN_MS = 1000;
/** So long it is to be read that all have stopped. */
const READ_MS = 5000;

export class Operator {
  #attempts = new Attempts();
  askingToResume = $state(false);
  /** When STOP ALL was ordered last, on the page's clock; until it is resumed or dismissed. */
  #ordered_ms = $state<number>();
  #told_ms = 0;
  /** Whether the monitor has taken it. */
  #isTaken = $state(false);
  #stopFailure = $state<string>();
  #confirmed_ms: number | undefined;

  readonly held: string[] = $derived(
    [...live.present.robots.values()].filter(({ name, state }) => state?.value.held && !state.value.out_of_service && !live.present.replayed.has(name)).map(({ name }) => name),
  );

  /** How far the last STOP ALL is; undefined where none is under way. */
  readonly stopping: StopProgress | undefined = $derived(
    this.#ordered_ms === undefined ? undefined : stopProgress(live.present, this.#ordered_ms, live.known_present_ms),
  );

  /** Why the last words of that order did not reach the monitor; undefined where they did. They are said again until they do. */
  readonly stopFailure: string | undefined = $derived(
    this.#stopFailure && (this.#isTaken ? `Those that have not confirmed cannot be told again now: ${this.#stopFailure}` : `STOP has not reached the robots: ${this.#stopFailure}`),
  );

  /** What went wrong with the last words, until the next. */
  get failure(): string | undefined {
    return this.#attempts.failure;
  }

  /** Acts at once. A viewer that may not steer is told so by the monitor. */
  stopAll(): void {
    this.askingToResume = false;
    [this.#confirmed_ms, this.#stopFailure, this.#isTaken] = [undefined, undefined, false];
    if (!rights.maySteer || live.playback) return void this.#say("hold", [], "STOP did not reach the robots");
    this.#ordered_ms = Date.now();
    this.#tellStop([], this.#ordered_ms);
  }

  /**
   * Called as time goes on: tells all again until the monitor has taken it, then those that have not confirmed, and ends the
   * report once all have.
   */
  refreshStop(now_ms: number): void {
    const left = this.stopping?.unconfirmed.map(({ name }) => name);
    if (!left) return;
    if (left.length > 0 || !this.#isTaken) {
      this.#confirmed_ms = undefined;
      if (now_ms - this.#told_ms >= AGAIN_MS) this.#tellStop(this.#isTaken ? left : [], now_ms);
      return;
    }
    this.#confirmed_ms ??= now_ms;
    if (now_ms - this.#confirmed_ms >= READ_MS) this.dismissStop();
  }

  /** Nobody is told again, and the report goes. */
  dismissStop(): void {
    [this.#ordered_ms, this.#stopFailure] = [undefined, undefined];
  }

  hold(robot: string): void {
    void this.#say("hold", [robot], `${robot} was not told to hold`);
  }

  /** Empty `robots` mean the whole team. */
  resume(robots: readonly string[]): void {
    this.askingToResume = false;
    this.dismissStop();
    void this.#say("resume", robots, "The robots were not told to resume");
  }

  /** Out of service it stands still whoever resumes, and takes no program that is pushed to all. */
  decommission(robot: string): void {
    void this.#say("decommission", [robot], `${robot} was not taken out of service`);
  }

  commission(robot: string): void {
    void this.#say("commission", [robot], `${robot} was not put into service`);
  }

  pushBumper(robot: string): void {
    void this.#say("push_bumper", [robot], `${robot}'s bumper was not pushed`);
  }

  #tellStop(robots: readonly string[], now_ms: number): void {
    this.#told_ms = now_ms;
    const order_ms = this.#ordered_ms;
    const became = (failure: string | undefined) => {
      if (this.#ordered_ms !== order_ms) return;
      this.#stopFailure = failure;
      this.#isTaken ||= failure === undefined;
    };
    void command("hold", robots).then(() => became(undefined), ({ message }: Error) => became(message));
  }

  async #say(kind: CommandKind, targets: readonly string[], failed: string): Promise<void> {
    if (live.playback && !rights.ask()) return;
    await this.#attempts.make(() => command(kind, targets), ({ message }) => `${failed}: ${message}`);
  }
}

export const operator = new Operator();
