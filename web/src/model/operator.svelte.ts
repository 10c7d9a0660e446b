// SPDX-License-Identifier: BSD-3-Clause
// What the operator tells the robots.

import { type CommandKind, command } from "../feed/api";
import { Attempts } from "../lib/attempts.svelte";
import { live } from "./live.svelte";

export class Operator {
  #attempts = new Attempts();
  askingToResume = $state(false);

  readonly held: string[] = $derived(
    [...live.present.robots.values()].filter(({ state }) => state?.value.held && !state.value.out_of_service).map((robot) => robot.name),
  );

  /** What went wrong with the last words, until the next. */
  get failure(): string | undefined {
    return this.#attempts.failure;
  }

  /** Acts at once. */
  stopAll(): void {
    this.askingToResume = false;
    void this.#say("hold", [], "STOP did not reach the robots");
  }

  hold(robot: string): void {
    void this.#say("hold", [robot], `${robot} was not told to hold`);
  }

  /** Empty `robots` mean the whole team. */
  resume(robots: readonly string[]): void {
    this.askingToResume = false;
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

  async #say(kind: CommandKind, targets: readonly string[], failed: string): Promise<void> {
    await this.#attempts.make(() => command(kind, targets), ({ message }) => `${failed}: ${message}`);
  }
}

export const operator = new Operator();
