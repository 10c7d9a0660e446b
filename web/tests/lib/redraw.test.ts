// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it } from "vitest";
import { type Frames, Redraw } from "../../src/lib/redraw";

/** A browser's frames on a stepped clock: one each 16 ms; one that shows something new costs what `cost_ms` says. */
class SteppedFrames implements Frames {
  at_ms = 0;
  cost_ms = 1;
  hasNew = false;
  #before: (() => void)[] = [];
  #behind: (() => void)[] = [];
  #timers: { at_ms: number; callback: () => void }[] = [];
  now_ms = () => this.at_ms;
  before = (callback: () => void) => void this.#before.push(callback);
  behind = (callback: () => void) => void this.#behind.push(callback);
  after = (callback: () => void, wait_ms: number) => void this.#timers.push({ at_ms: this.at_ms + wait_ms, callback });

  frame(): void {
    const began_ms = this.at_ms;
    for (const { callback } of this.#timers.filter(({ at_ms }) => at_ms <= began_ms)) callback();
    this.#timers = this.#timers.filter(({ at_ms }) => at_ms > began_ms);
    this.#before.splice(0).forEach((callback) => callback());
    this.at_ms += this.hasNew ? this.cost_ms : 1;
    this.hasNew = false;
    this.#behind.splice(0).forEach((callback) => callback());
    this.at_ms = Math.max(began_ms + 16, this.at_ms);
  }
}

let frames: SteppedFrames;
let drawn_ms: number[];
/** What was drawn, and when, in ms. */
let drawn: string[];
let redraw: Redraw;
beforeEach(() => {
  frames = new SteppedFrames();
  [drawn_ms, drawn] = [[], []];
  redraw = new Redraw((isUrgent) => ((frames.hasNew = true), drawn_ms.push(frames.at_ms), drawn.push(`${isUrgent ? "news" : "all"} at ${frames.at_ms}`)), frames);
});

it("draws once a frame, however often it is asked, and not at all where nobody asks", () => {
  for (let i = 0; i < 50; i += 1) redraw.ask();
  frames.frame();
  frames.frame();
  expect(drawn_ms).toEqual([1]);
});

it("draws behind a frame and not within it: a key has its turn between script and browser", () => {
  const order: string[] = [];
  redraw = new Redraw(() => order.push("draw"), frames);
  redraw.ask();
  frames.before(() => order.push("frame"));
  frames.behind(() => order.push("key"));
  frames.frame();
  expect(order).toEqual(["frame", "key", "draw"]);
});

it("leaves three parts of four of the time to others where drawing is slow, but waits no longer than a quarter of a second", () => {
  const drawnIn1s = (cost_ms: number) => {
    frames.cost_ms = cost_ms;
    drawn_ms = [];
    for (const end_ms = frames.at_ms + 1000; frames.at_ms < end_ms; frames.frame()) redraw.ask();
    return drawn_ms.length;
  };
  expect(drawnIn1s(2)).toBeGreaterThanOrEqual(30);
  expect(drawnIn1s(20) * 20).toBeLessThan(270);
  expect(drawnIn1s(60) * 60).toBeLessThan(270);
  expect(drawnIn1s(150)).toBeGreaterThanOrEqual(3); // and for two frames
});

it("draws an event at once, though what is steady has to wait", () => {
  frames.cost_ms = 25;
  redraw.ask();
  frames.frame();
  redraw.ask();
  frames.frame();
  expect(drawn_ms).toEqual([1]);
  redraw.askNow();
  expect(drawn_ms).toEqual([1, 41]);
});

it("draws a burst of events once at once, and once with all of them", () => {
  for (let i = 0; i < 50; i += 1) redraw.askNow();
  expect(drawn_ms).toEqual([0]);
  for (let i = 0; i < 5; i += 1) frames.frame();
  expect(drawn_ms.length).toBe(2);
});

it("draws what happens while a frame is under way as soon as that is over, however slow drawing is", () => {
  frames.cost_ms = 25;
  redraw.askNow();
  redraw.askNow();
  frames.frame();
  expect(drawn_ms).toEqual([0, 25]);
  frames.frame();
  frames.frame();
  expect(drawn_ms).toEqual([0, 25]);
});

it("draws nothing else in the frame that shows an event, and the rest in the next one", () => {
  redraw.ask();
  redraw.askNow();
  redraw.ask();
  frames.frame();
  expect(drawn).toEqual(["news at 0"]);
  frames.frame();
  frames.frame();
  expect(drawn).toEqual(["news at 0", "all at 17"]);
});

it("draws the rest though something happens in each frame", () => {
  for (let i = 0; i < 8; i += 1) {
    redraw.ask();
    redraw.askNow();
    frames.frame();
  }
  expect(drawn.filter((each) => each.startsWith("all")).length).toBeGreaterThanOrEqual(4);
});
