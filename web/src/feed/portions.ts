// SPDX-License-Identifier: BSD-3-Clause
// What a page is handed at once: so much that it looks again for its reader's keys a few milliseconds later.
import type { Arrival } from "./feed";

/** So many messages a page takes in within a few milliseconds. */
export const PORTION = 40;

/** A time between two messages of a topic, by when the monitor received them. */
export interface Pause {
  readonly from_ms: number;
  readonly to_ms: number;
}

/** The newest of some messages of one topic, or one that tells what happened. */
export interface Waiting extends Arrival {
  /** How many they are. */
  readonly count: number;
  /** Of a robot's states: when none came for longer than a robot takes that is well. */
  readonly pauses?: readonly Pause[];
}

/** A message that the page has not seen yet. */
export interface News {
  readonly topic: string;
  readonly message: unknown;
  readonly received_ms: number;
  /** How many messages came on the topic since the last one that the page saw; this is the newest. */
  readonly count: number;
  readonly pauses?: readonly Pause[];
}

export interface Portion {
  /**
   * What the page knows then is what the monitor knew at this time, on the page's clock. It moves on with the last portion
   * alone: until then, some robots have been told of and others have not, and these are not to be called silent.
   */
  readonly told_ms: number;
  /** In the order in which they came. */
  readonly news: readonly News[];
}

/** Cuts what was waiting at one instant. What comes meanwhile waits until all of it has been handed over. */
export class Portions {
  #rest: readonly Waiting[] = [];
  #told_ms = 0;
  /** Once the rest has been handed over. */
  #next_ms = 0;

  get isOver(): boolean {
    return this.#rest.length === 0;
  }

  /** Requires: isOver. `told_ms`: until when the monitor told what waits. */
  begin(waiting: readonly Waiting[], told_ms: number): void {
    [this.#rest, this.#next_ms] = [waiting, told_ms];
  }

  /** The next portion, decoded; `damaged` is called for what cannot be. */
  take(damaged: (topic: string, reason: string) => void): Portion {
    const portion = this.#rest.slice(0, PORTION);
    this.#rest = this.#rest.slice(PORTION);
    if (this.isOver) this.#told_ms = this.#next_ms;
    return { told_ms: this.#told_ms, news: portion.flatMap((each) => decoded(each, damaged)) };
  }

  /** Forgets what waits and the time. */
  clear(): void {
    [this.#rest, this.#told_ms, this.#next_ms] = [[], 0, 0];
  }
}

function decoded({ topic, decode, received_ms, count, pauses }: Waiting, damaged: (topic: string, reason: string) => void): News[] {
  try {
    return [{ topic, message: decode(), received_ms, count, ...(pauses && { pauses }) }];
  } catch (error) {
    damaged(topic, (error as Error).message);
    return [];
  }
}
