// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it } from "vitest";
import type { PlaybackRequest, PlaybackStatus } from "../../src/feed/playback";
import { Playback } from "../../src/model/playback.svelte";

const START_NS = 1_732_795_200_000_000_000n;
const ns = (after_s: number) => START_NS + BigInt(Math.round(after_s * 1e9));
let asked: PlaybackRequest[];
let playback: Playback;
const seeks_s = () => asked.flatMap(({ seek_ns }) => (seek_ns === undefined ? [] : Number(seek_ns - START_NS) / 1e9));
const answer = (after_s: number, status: PlaybackStatus = "playing", isBorder = true) => {
  playback.told({ status, now_ns: ns(after_s), speed: 1, sought: isBorder, id: asked.at(-1)?.id ?? "" }, isBorder);
  playback.drawn(playback.now_ms);
  if (isBorder) playback.settled();
};
beforeEach(() => {
  asked = [];
  playback = new Playback("office.mcap", (request) => asked.push(request));
  playback.begun({ start_ns: START_NS, end_ns: ns(60) }, ns(10));
  playback.drawn(playback.now_ms);
  playback.settled();
});

it("is where the monitor began it, and plays", () => {
  expect([playback.position_s, playback.duration_s, playback.plays, playback.start_ms]).toEqual([10, 60, true, Number(START_NS) / 1e6]);
});

it("counts a seek at once, and asks for one at a time, at last for the newest", () => {
  for (const to_s of [20, 21, 22, 23]) playback.seek(to_s);
  expect([playback.position_s, seeks_s()]).toEqual([23, [20]]);
  playback.told({ status: "playing", now_ns: ns(20), speed: 1, sought: true, id: "" }, true);
  expect(seeks_s()).toEqual([20]); // what it went to is yet to be drawn
  answer(20);
  expect([playback.position_s, seeks_s()]).toEqual([23, [20, 23]]);
  answer(23);
  expect([playback.position_s, seeks_s()]).toEqual([23, [20, 23]]);
});

it("takes what is not the answer to a seek for none", () => {
  playback.seek(20);
  answer(11, "playing", false);
  expect([playback.position_s, playback.now_ms]).toEqual([20, Number(ns(10)) / 1e6]);
});

it("goes nowhere outside of the recording", () => {
  playback.seek(-5);
  answer(0);
  playback.seek(600);
  expect(seeks_s()).toEqual([0, 60]);
});

it("stands still to step, and steps on from where it was told to go", () => {
  playback.step(0.1);
  playback.step(0.1);
  expect(asked).toMatchObject([{ plays: false, seek_ns: ns(10.1) }]);
  expect(playback.position_s).toBeCloseTo(10.2);
  answer(10.1, "paused");
  expect(asked.at(-1)).toMatchObject({ plays: false, seek_ns: ns(10.2) });
  expect(playback.plays).toBe(false);
});

it("plays and stands still by turns, as fast as it is told", () => {
  playback.toggle();
  playback.setSpeed(20);
  playback.toggle();
  expect(asked.map(({ plays, speed, seek_ns }) => [plays, speed, seek_ns])).toEqual([[false, 1, undefined], [false, 20, undefined], [true, 20, undefined]]);
  expect(new Set(asked.map(({ id }) => id)).size).toBe(3);
});

it("plays from the start when it is at its end", () => {
  answer(60, "ended", false);
  expect(playback.plays).toBe(false);
  playback.toggle();
  expect(asked.at(-1)).toMatchObject({ plays: true, seek_ns: START_NS });
});

it("is opened anew where the connection was lost while it sought", () => {
  playback.seek(20);
  playback.seek(30);
  playback.begun({ start_ns: START_NS, end_ns: ns(60) }, ns(20));
  playback.settled();
  expect(seeks_s()).toEqual([20, 30]);
});
