// SPDX-License-Identifier: BSD-3-Clause
/** A page clock that moved by more than this against the steady clock was set. */
const SET_MS = 500;
/** The monitor's clock was set back if all that came for so long was sent before what came earlier. */
const AGREED_MS = 3000;
/** What is sent so little before the newest is no sign of a clock that was set. */
const JUMP_MS = 2000;
/** So much two clocks may drift apart. */
const DRIFT_MS_PER_S = 0.2;

/**
 * How far the page's clock is ahead of the monitor's, so that ages are right where clocks differ.
 * The offset is the smallest (arrival − sending) seen: what exceeds it is delay or age. It rises where
 * that is no delay: slowly with the drift of clocks, at once when the page's clock was set, and after
 * a while when the monitor's was set back, since then all channels agree.
 */
export class ClockOffset {
  #offset_ms = Number.POSITIVE_INFINITY;
  /** Of the page's clock less the steady one. */
  #lead_ms: number | undefined;
  #seen_ms: number | undefined;
  #newestSent_ms = Number.NEGATIVE_INFINITY;
  /** All that came since then was sent long before the newest. */
  #back: { since_ms: number; least_ms: number; newestSent_ms: number } | undefined;

  /** When the monitor received a message, on the page's clock; never later than `arrived_ms`. */
  received_ms(sent_ms: number, arrived_ms: number, steady_ms = performance.now()): number {
    this.#followPageClock(arrived_ms - steady_ms);
    this.#followDrift(steady_ms);
    this.#followMonitorClock(sent_ms, arrived_ms - sent_ms, steady_ms);
    this.#offset_ms = Math.min(this.#offset_ms, arrived_ms - sent_ms);
    return sent_ms + this.#offset_ms;
  }

  /** A machine that slept looks the same; the next message, which has no such delay, puts that right. */
  #followPageClock(lead_ms: number): void {
    const moved_ms = lead_ms - (this.#lead_ms ?? lead_ms);
    if (Math.abs(moved_ms) > SET_MS) this.#offset_ms += moved_ms;
    this.#lead_ms = lead_ms;
  }

  #followDrift(steady_ms: number): void {
    this.#offset_ms += (Math.max(0, steady_ms - (this.#seen_ms ?? steady_ms)) / 1000) * DRIFT_MS_PER_S;
    this.#seen_ms = steady_ms;
  }

  #followMonitorClock(sent_ms: number, sample_ms: number, steady_ms: number): void {
    if (sent_ms > this.#newestSent_ms - JUMP_MS) {
      this.#newestSent_ms = Math.max(this.#newestSent_ms, sent_ms);
      this.#back = undefined;
      return;
    }
    this.#back ??= { since_ms: steady_ms, least_ms: sample_ms, newestSent_ms: sent_ms };
    this.#back.least_ms = Math.min(this.#back.least_ms, sample_ms);
    this.#back.newestSent_ms = Math.max(this.#back.newestSent_ms, sent_ms);
    if (steady_ms - this.#back.since_ms < AGREED_MS) return;
    [this.#offset_ms, this.#newestSent_ms] = [this.#back.least_ms, this.#back.newestSent_ms];
    this.#back = undefined;
  }
}
