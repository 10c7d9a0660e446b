// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { ClockOffset } from "../../src/feed/clock_offset";

const SECOND_MS = 1000;
const HOUR_MS = 3600 * SECOND_MS;

/** A page that takes the monitor's time ten times a second, each with the same delay. */
class Page {
  readonly #clock = new ClockOffset();
  #steady_ms = 0;
  pageAhead_ms = 5000;
  monitorAhead_ms = 0;

  /** Returns how old the newest message seems to the page. */
  age_ms(seconds: number, delay_ms = 20): number {
    let age_ms = NaN;
    for (let i = 0; i < seconds * 10; ++i) age_ms = this.take_ms(delay_ms);
    return age_ms;
  }
  take_ms(delay_ms: number): number {
    this.#steady_ms += 100;
    const arrived_ms = HOUR_MS + this.#steady_ms + this.pageAhead_ms;
    const sent_ms = HOUR_MS + this.#steady_ms - delay_ms + this.monitorAhead_ms;
    return arrived_ms - this.#clock.received_ms(sent_ms, arrived_ms, this.#steady_ms);
  }
}

describe("the offset of the page's clock", () => {
  it("hides what the two clocks differ, and no delay that comes later", () => {
    const page = new Page();
    expect(page.age_ms(1)).toBeCloseTo(0, 0);
    expect(page.take_ms(3020)).toBeCloseTo(3000, 0);
    expect(page.age_ms(10, 1020)).toBeCloseTo(1000, -1);
  });

  it("follows a page's clock that is set forward or back", () => {
    for (const jump_ms of [HOUR_MS, -HOUR_MS, 40 * SECOND_MS]) {
      const page = new Page();
      page.age_ms(1);
      page.pageAhead_ms += jump_ms;
      expect(page.take_ms(20)).toBeCloseTo(0, 0);
      expect(page.take_ms(2020)).toBeCloseTo(2000, 0);
    }
  });

  it("follows a monitor's clock that is set forward at once", () => {
    const page = new Page();
    page.age_ms(1);
    page.monitorAhead_ms = HOUR_MS;
    expect(page.take_ms(20)).toBeCloseTo(0, 0);
  });

  it("follows a monitor's clock that is set back, once all that comes agrees", () => {
    const page = new Page();
    page.age_ms(1);
    page.monitorAhead_ms = -HOUR_MS;
    expect(page.take_ms(20)).toBeGreaterThan(HOUR_MS - SECOND_MS);
    expect(page.age_ms(4)).toBeCloseTo(0, 0);
    expect(page.take_ms(2020)).toBeCloseTo(2000, 0);
  });

  it("takes an old message among new ones for what it is", () => {
    const page = new Page();
    page.age_ms(1);
    for (let i = 0; i < 100; ++i) {
      page.take_ms(20);
      expect(page.take_ms(30 * SECOND_MS)).toBeGreaterThan(29 * SECOND_MS);
    }
  });

  it("rises with a drift of the clocks", () => {
    const page = new Page();
    page.age_ms(1);
    for (let second = 0; second < 600; ++second) {
      page.pageAhead_ms += 0.1;
      page.age_ms(1);
    }
    expect(page.take_ms(20)).toBeLessThan(5);
  });
});
