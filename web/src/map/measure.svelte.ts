// SPDX-License-Identifier: BSD-3-Clause
import { metres, degrees } from "../lib/format";

interface Place {
  readonly x_m: number;
  readonly y_m: number;
}

/** Two places and what lies between them. */
export class Measure {
  active = $state(false);
  from = $state.raw<Place>();
  to = $state.raw<Place>();
  #fixed = $state(false);

  readonly words: string = $derived(
    this.from && this.to
      ? `${metres(Math.hypot(this.to.x_m - this.from.x_m, this.to.y_m - this.from.y_m))}, ${degrees(Math.atan2(this.to.y_m - this.from.y_m, this.to.x_m - this.from.x_m))}`
      : this.from
        ? "choose the other end"
        : "choose where to measure from",
  );

  toggle(): void {
    this.active = !this.active;
    this.from = this.to = undefined;
    this.#fixed = false;
  }

  /** A place was chosen: an end, or the beginning of another. */
  choose(place: Place): void {
    const isEnd = this.from !== undefined && !this.#fixed;
    if (isEnd) this.to = place;
    else [this.from, this.to] = [place, undefined];
    this.#fixed = isEnd;
  }

  /** The pointer is there; nothing is chosen yet. */
  pointAt(place: Place): void {
    if (this.from && !this.#fixed) this.to = place;
  }
}
