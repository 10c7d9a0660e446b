// SPDX-License-Identifier: BSD-3-Clause
// What an instructor orders of the simulation, and what it answers. Orders act now, whatever instant is shown.

import { orderSimulation, type SimulationOrder } from "../feed/api";
import type { SimulationBody, SimulationState } from "../feed/messages";
import { live } from "./live.svelte";
import { isThere } from "./simulation";

const KEPT = 6;

export interface Answer {
  readonly number: number;
  readonly done: boolean;
  readonly words: string;
}

interface Place {
  readonly x_m: number;
  readonly y_m: number;
}

export class Instructor {
  /** The newest first. */
  answers = $state.raw<readonly Answer[]>([]);
  /** Whether bodies can be moved on the map. */
  moves = $state(false);
  #given = 0;
  /** Where bodies were ordered to that the simulation has not yet put there. */
  #targets = $state.raw<ReadonlyMap<string, Place>>(new Map());
  #moving = new Set<string>();

  /** The simulation as it is now; undefined where none is heard. */
  readonly simulation: SimulationState | undefined = $derived(
    isThere(live.present.simulation, live.known_present_ms) ? live.present.simulation.value : undefined,
  );

  readonly isOffered: boolean = $derived(this.simulation !== undefined);

  /** Returns whether it was done. The answer says what, or why not. */
  async give(order: SimulationOrder): Promise<boolean> {
    const simulation = this.simulation?.simulation;
    if (simulation === undefined) return this.#answered(false, "No simulation is heard any more.");
    try {
      return this.#answered(true, (await orderSimulation(simulation, order)).text);
    } catch (error) {
      return this.#answered(false, (error as Error).message);
    }
  }

  /** Where a body is, or is about to be. */
  placeOf({ name, x_m, y_m }: SimulationBody): Place {
    return this.#targets.get(name) ?? { x_m, y_m };
  }

  /** Moves a body. While it is under way the newest place counts, so that a key that is held moves it on. */
  async moveTo(name: string, place: Place): Promise<void> {
    this.#targets = new Map(this.#targets).set(name, place);
    if (this.#moving.has(name)) return;
    this.#moving.add(name);
    for (let to: Place | undefined = place, done = true; to && done; ) {
      done = await this.give({ order: "move", subject: name, ...to });
      const newest = this.#targets.get(name);
      to = newest === to ? undefined : newest;
    }
    this.#moving.delete(name);
    this.#targets = new Map([...this.#targets].filter(([each]) => each !== name));
  }

  #answered(done: boolean, words: string): boolean {
    this.#given += 1;
    this.answers = [{ number: this.#given, done, words }, ...this.answers].slice(0, KEPT);
    return done;
  }
}

export const instructor = new Instructor();
