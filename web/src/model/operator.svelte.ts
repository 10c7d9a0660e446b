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
  #confirmed_ms: number | undefined;

  readonly held: string[] = $derived(
    [...live.present.robots.values()].filter(({ name, state }) => state?.value.held && !state.value.out_of_service && !live.present.replayed.has(name)).map(({ name }) => name),
  );

  /** How far the last STOP ALL is; undefined where none is under way. */
  readonly stopping: StopProgress | undefined = $derived(
    this.#ordered_ms === undefined ? undefined : stopProgress(live.present, this.#ordered_ms, live.known_present_ms),
  );

  /** What went wrong with the last words, until the next. */
  get failure(): string | undefined {
    return this.#attempts.failure;
  }

  /** Acts at once. A viewer that may not steer is told so by the monitor. */
  stopAll(): void {
    this.askingToResume = false;
    if (rights.maySteer) this.#ordered_ms = this.#told_ms = Date.now();
    this.#confirmed_ms = undefined;
    void this.#say("hold", [], "STOP did not reach the robots");
  }

  /** Called as time goes on: tells those again that have not confirmed, and ends the report once all have. */
  refreshStop(now_ms: number): void {
    const left = this.stopping?.unconfirmed.map(({ name }) => name);
    if (!left) return;
    if (left.length > 0) {
      this.#confirmed_ms = undefined;
      if (now_ms - this.#told_ms >= AGAIN_MS) this.#tellAgain(left, now_ms);
      return;
    }
    this.#confirmed_ms ??= now_ms;
    if (now_ms - this.#confirmed_ms >= READ_MS) this.dismissStop();
  }

  /** Nobody is told again, and the report goes. */
  dismissStop(): void {
    this.#ordered_ms = undefined;
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

  #tellAgain(robots: readonly string[], now_ms: number): void {
    this.#told_ms = now_ms;
    void this.#say("hold", robots, "STOP did not reach the robots");
  }

  async #say(kind: CommandKind, targets: readonly string[], failed: string): Promise<void> {
    if (live.playback && !rights.ask()) return;
    await this.#attempts.make(() => command(kind, targets), ({ message }) => `${failed}: ${message}`);
  }
}

export const operator = new Operator();
