// SPDX-License-Identifier: BSD-3-Clause
import type { Team } from "./model";

const STEP_MS = 500;
/** So far back every step is kept; farther, one of four: nobody looks there for a tenth of a second, and memory costs. */
const FINE_MS = 120_000;
const COARSE_STEP_MS = 4 * STEP_MS;
const KEPT_MS = 600_000;

export interface Instant {
  readonly at_ms: number;
  /** The newest time of which the monitor had told then: by it a robot was silent, or the page was only behind. */
  readonly known_ms: number;
  readonly team: Team;
}

/**
 * The last ten minutes of the team, an instant each half second, and each two seconds farther back. Instants
 * share what did not change between them. The floor's grid is left out: it is large, and only grows.
 */
export class History {
  #old: Instant[] = [];
  #fine: Instant[] = [];

  record(team: Team, at_ms: number, known_ms = at_ms): void {
    const newest = this.#fine.at(-1);
    if (newest && at_ms - newest.at_ms < STEP_MS) return;
    this.#fine.push({ at_ms, known_ms, team: { ...team, grid: undefined } });
    while (this.#fine[0]!.at_ms < at_ms - FINE_MS) this.#age(this.#fine.shift()!);
    const kept_from = this.#old.findIndex((instant) => instant.at_ms >= at_ms - KEPT_MS);
    if (kept_from > 0) this.#old.splice(0, kept_from);
  }

  get earliest_ms(): number | undefined {
    return (this.#old[0] ?? this.#fine[0])?.at_ms;
  }

  /** Every instant that is kept, the earliest first. */
  get instants(): readonly Instant[] {
    return [...this.#old, ...this.#fine];
  }

  /** The newest instant that was kept until `at_ms`, or the earliest one known. */
  at(at_ms: number): Instant | undefined {
    const instants = this.instants;
    let low = 0;
    let high = instants.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (instants[middle]!.at_ms <= at_ms) low = middle + 1;
      else high = middle;
    }
    return instants[Math.max(low - 1, 0)];
  }

  /** What is newer than `at_ms` has not happened yet. */
  forgetAfter(at_ms: number): void {
    const isPast = (instant: Instant) => instant.at_ms <= at_ms;
    [this.#old, this.#fine] = [this.#old.filter(isPast), this.#fine.filter(isPast)];
  }

  clear(): void {
    [this.#old, this.#fine] = [[], []];
  }

  #age(instant: Instant): void {
    const before = this.#old.at(-1);
    if (!before || instant.at_ms - before.at_ms >= COARSE_STEP_MS) this.#old.push(instant);
  }
}
