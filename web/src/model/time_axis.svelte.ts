// SPDX-License-Identifier: BSD-3-Clause
// The span of time that the timeline and every plot show, and the instant that the pointer is at in any of them.

import { live } from "./live.svelte";
import { clampSpan_s, zoomed } from "./time_span";

class TimeAxis {
  span_s = $state(180);
  /** Where the axis ends; undefined: now, and on with it. */
  #end_ms = $state<number>();
  pointed_ms = $state<number>();

  constructor() {
    live.onRewind(() => this.follow());
  }

  readonly follows: boolean = $derived(this.#end_ms === undefined);
  /** The present, as far as the axis has got. */
  readonly present_ms: number = $derived(live.step_ms);
  readonly to_ms: number = $derived(this.#end_ms ?? this.present_ms);
  readonly from_ms: number = $derived(this.to_ms - this.span_s * 1000);

  /** What is at `at_ms` stays where it is; where the axis follows the present, its end does. */
  zoom(factor: number, at_ms = this.follows ? this.to_ms : (this.from_ms + this.to_ms) / 2): void {
    const { from_ms, to_ms } = zoomed(this, factor, at_ms);
    this.span_s = (to_ms - from_ms) / 1000;
    if (!this.follows || at_ms < this.to_ms) this.#end(to_ms);
  }
  setSpan(span_s: number): void {
    this.span_s = clampSpan_s(span_s);
  }
  pan(by_ms: number): void {
    this.#end(this.to_ms + by_ms);
  }
  /** Brings an instant into sight. */
  show(at_ms: number): void {
    if (at_ms < this.from_ms || at_ms > this.to_ms) this.#end(at_ms + this.span_s * 500);
  }
  follow(): void {
    this.#end_ms = undefined;
  }
  #end(end_ms: number): void {
    this.#end_ms = end_ms >= live.present_ms ? undefined : Math.max(end_ms, live.earliest_ms + 1000);
  }
}

export const axis = new TimeAxis();

/** Shows the team as it was at that instant; close to the present: as it is. A recording goes on from there. */
export function showInstant(at_ms: number): void {
  if (live.playback) return live.playback.seekTo(at_ms);
  live.instant_ms = at_ms >= live.present_ms - 300 ? undefined : Math.max(at_ms, live.earliest_ms);
  if (live.instant_ms !== undefined) axis.show(live.instant_ms);
}

/** The axis goes along with the present again, which is shown. */
export function backToLive(): void {
  live.instant_ms = undefined;
  axis.follow();
}
