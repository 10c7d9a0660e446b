import type { Team } from "./model";

const STEP_MS = 500;
const KEPT_MS = 600_000;

export interface Instant {
  readonly at_ms: number;
  readonly team: Team;
}

/**
 * The last ten minutes of the team, an instant each half second. Instants share what did not change
 * between them. The floor's grid is left out: it is large, and only grows.
 */
export class History {
  #instants: Instant[] = [];

  record(team: Team, at_ms: number): void {
    const newest = this.#instants.at(-1);
    if (newest && at_ms - newest.at_ms < STEP_MS) return;
    this.#instants.push({ at_ms, team: { ...team, grid: undefined } });
    const kept_from = this.#instants.findIndex((instant) => instant.at_ms >= at_ms - KEPT_MS);
    if (kept_from > 0) this.#instants.splice(0, kept_from);
  }

  get earliest_ms(): number | undefined {
    return this.#instants[0]?.at_ms;
  }

  /** Every instant that is kept, the earliest first. */
  get instants(): readonly Instant[] {
    return this.#instants;
  }

  /** The team as it was at `at_ms`, or at the earliest instant known. */
  at(at_ms: number): Team | undefined {
    let low = 0;
    let high = this.#instants.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.#instants[middle]!.at_ms <= at_ms) low = middle + 1;
      else high = middle;
    }
    return this.#instants[Math.max(low - 1, 0)]?.team;
  }
}
