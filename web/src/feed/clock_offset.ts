// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far the page's clock is ahead of the monitor's, so that ages are right where clocks differ.
 * The offset is the smallest (arrival − sending) seen: what exceeds it is delay or age.
 */
export class ClockOffset {
  #offset_ms = Number.POSITIVE_INFINITY;

  /** When the monitor received a message, on the page's clock; never later than `arrived_ms`. */
  received_ms(sent_ms: number, arrived_ms: number): number {
    this.#offset_ms = Math.min(this.#offset_ms, arrived_ms - sent_ms);
    return sent_ms + this.#offset_ms;
  }
}
