// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { Breaks_Constants } from "../../src/feed/messages";
import { REPLAYED } from "../../src/feed/topics";
import { emptyTeam } from "../../src/model/model";
import { stopProgress, stopSentence } from "../../src/model/stop_order";
import { breaks, state, T0_MS, told } from "./told";

const ORDERED_MS = T0_MS + 1000;
const at = (robot: string, held: boolean, received_ms: number, more = {}) =>
  [`/${robot}/state`, state({ robot, held, ...more }), received_ms] as [string, unknown, number];
const sentence = (messages: [string, unknown, number][], known_ms: number) => stopSentence(stopProgress(told(messages), ORDERED_MS, known_ms));

describe("STOP ALL", () => {
  it("is over when each robot has said since that it stands still", () => {
    const messages = [at("io", true, ORDERED_MS + 50), at("ganymede", true, ORDERED_MS + 60)];
    expect(sentence(messages, ORDERED_MS + 100)).toBe("All 2 robots have stopped.");
    expect(sentence(messages.slice(1), ORDERED_MS + 100)).toBe("ganymede has stopped.");
  });
  it("names who has not answered, and for how long", () => {
    const messages = [at("io", true, ORDERED_MS + 50), at("ganymede", true, ORDERED_MS + 50), at("callisto", false, ORDERED_MS - 9000)];
    expect(sentence(messages, ORDERED_MS + 5000)).toBe("2 of 3 stopped; callisto has not answered for 14 s.");
  });
  it("does not believe what was said before the order", () => {
    expect(sentence([at("io", true, ORDERED_MS - 1)], ORDERED_MS + 500)).toBe("0 of 1 stopped; io has not answered for 0.5 s.");
  });
  it("names who answers and drives on", () => {
    expect(sentence([at("io", false, ORDERED_MS + 2900)], ORDERED_MS + 3000)).toBe("0 of 1 stopped; io answers but has not stopped for 3.0 s.");
  });
  it("waits for no robot that a recording plays", () => {
    const messages = [at("io", true, ORDERED_MS + 50), at("ganymede", false, ORDERED_MS + 50), [REPLAYED, ["ganymede"], 0]];
    expect(sentence(messages as [string, unknown, number][], ORDERED_MS + 100)).toBe("io has stopped.");
  });
  it("counts a robot out of service as one that stands still", () => {
    expect(sentence([at("io", false, ORDERED_MS + 50, { out_of_service: true })], ORDERED_MS + 100)).toBe("io has stopped.");
  });
  it("does not take a stop at a break point for one of its own", () => {
    const stands = (stopped: boolean) => ["/io/breaks", breaks({ stopped, stopped_by: stopped ? Breaks_Constants.STEP : Breaks_Constants.NOTHING }), ORDERED_MS + 50] as [string, unknown, number];
    expect(sentence([stands(true), at("io", true, ORDERED_MS + 100)], ORDERED_MS + 200)).toBe("0 of 1 stopped; io has not answered for 0.2 s.");
    expect(sentence([stands(false), at("io", true, ORDERED_MS + 100)], ORDERED_MS + 200)).toBe("io has stopped.");
  });
  it("counts whom it does not name, the longest silent first", () => {
    const messages = ["a", "b", "c", "d", "e"].map((name, i) => at(name, false, ORDERED_MS - i * 1000));
    expect(sentence(messages, ORDERED_MS + 1000)).toMatch(/^0 of 5 stopped; e has not answered for 5\.0 s, d .*, c .*, and 2 more robots have not confirmed\.$/);
  });
  it("says so where no robot is heard", () => {
    expect(stopSentence(stopProgress(emptyTeam, ORDERED_MS, ORDERED_MS))).toBe("No robot is heard that could stop.");
  });
});
