// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it } from "vitest";
import { type Batch, Inbox } from "../../src/feed/inbox";
import { PORTION } from "../../src/feed/portions";

const undamaged = () => expect.unreachable("nothing is damaged");
const names = Array.from({ length: 2 * PORTION + 5 }, (_, i) => `topic${i}`);

let inbox: Inbox;
let decoded: number;
const put = (topic: string, message: unknown, received_ms: number) => inbox.put({ topic, received_ms, decode: () => ((decoded += 1), message) });
const take = () => inbox.take(undamaged, 0);
const takeAll = () => {
  const batches: Batch[] = [];
  while (inbox.due_ms(0) === 0) batches.push(take());
  return batches;
};
beforeEach(() => {
  [inbox, decoded] = [new Inbox(), 0];
});

it("what a page slept through comes in portions, in the order in which it came", () => {
  names.forEach((name, i) => put(`/team/${name}`, name, 1000 + i));
  const batches = takeAll();
  expect(batches.map(({ news }) => news.length)).toEqual([PORTION, PORTION, 5]);
  expect(batches.flatMap(({ news }) => news.map(({ message }) => message))).toEqual(names);
});

it("the time until which all is known moves on with the last portion alone", () => {
  put("/team/before", "before", 500);
  expect(take().told_ms).toBe(500);
  names.forEach((name, i) => put(`/team/${name}`, name, 1000 + i));
  inbox.told(9000);
  expect(takeAll().map(({ told_ms }) => told_ms)).toEqual([500, 500, 9000]);
});

it("what comes between portions waits for the last of them, and its time with it", () => {
  names.forEach((name) => put(`/team/${name}`, "old", 1000));
  take();
  put("/team/topic0", "new", 2000);
  put("/io/transition", "grabs", 2001);
  inbox.told(3000);
  const batches = takeAll();
  expect(batches.map(({ told_ms }) => told_ms)).toEqual([0, 1000, 3000]);
  expect(batches.at(-1)!.news.map(({ message }) => message)).toEqual(["new", "grabs"]);
});

it("a message is decoded with its own portion", () => {
  names.forEach((name) => put(`/team/${name}`, name, 1000));
  take();
  expect(decoded).toBe(PORTION);
});

it("dropped events are told once", () => {
  for (let i = 0; i < 20_003; i += 1) put("/io/transition", i, i);
  expect([take().dropped, take().dropped]).toEqual([3, 0]);
});

it("another connection forgets the portions that were left", () => {
  names.forEach((name) => put(`/team/${name}`, name, 1000));
  take();
  inbox.clear();
  expect(inbox.due_ms(0)).toBe(Infinity);
  put("/team/objects", "new", 2000);
  expect(take()).toEqual({ told_ms: 2000, dropped: 0, news: [{ topic: "/team/objects", message: "new", received_ms: 2000, count: 1 }] });
});
