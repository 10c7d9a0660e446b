// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { Inbox } from "../../src/feed/inbox";

const undamaged = () => expect.unreachable("nothing is damaged");

function arrival(topic: string, message: unknown, received_ms: number, decoded: unknown[] = []) {
  return { topic, received_ms, decode: () => (decoded.push(message), message) };
}

describe("what came since the page looked last", () => {
  it("is the newest of what tells how things stand, and how many there were; the rest is not even decoded", () => {
    const inbox = new Inbox();
    const decoded: unknown[] = [];
    for (let i = 1; i <= 600; ++i) inbox.put(arrival("/io/state", i, i * 100, decoded));
    expect(inbox.take(undamaged).news).toEqual([{ topic: "/io/state", message: 600, received_ms: 60_000, count: 600 }]);
    expect(decoded).toEqual([600]);
  });
  it("is all that happened, in the order in which it came", () => {
    const inbox = new Inbox();
    inbox.put(arrival("/io/state", "before", 1));
    inbox.put(arrival("/io/transition", "first", 2));
    inbox.put(arrival("/io/transition", "second", 3));
    inbox.put(arrival("/io/state", "after", 4));
    inbox.put(arrival("/team/push_progress", "third", 5));
    expect(inbox.take(undamaged).news.map(({ message }) => message)).toEqual(["first", "second", "after", "third"]);
  });
  it("is told once", () => {
    const inbox = new Inbox();
    inbox.put(arrival("/io/state", "once", 1));
    inbox.take(undamaged);
    expect(inbox.take(undamaged).news).toEqual([]);
  });
  it("says until when the monitor told it, also where it told of nothing but the time", () => {
    const inbox = new Inbox();
    inbox.put(arrival("/io/state", "a", 1000));
    expect(inbox.take(undamaged).told_ms).toBe(1000);
    inbox.told(1100);
    expect(inbox.take(undamaged).told_ms).toBe(1100);
  });
  it("names what is damaged and keeps the rest", () => {
    const inbox = new Inbox();
    inbox.put({ topic: "/io/state", received_ms: 1, decode: () => { throw new Error("too short"); } });
    inbox.put(arrival("/io/variables", "whole", 2));
    const damage: string[] = [];
    const { news } = inbox.take((topic, reason) => damage.push(`${topic}: ${reason}`));
    expect(damage).toEqual(["/io/state: too short"]);
    expect(news.map(({ message }) => message)).toEqual(["whole"]);
  });
  it("counts the events that a page could not take in for hours", () => {
    const inbox = new Inbox();
    for (let i = 0; i < 20_007; ++i) inbox.put(arrival("/io/transition", i, i));
    const { news, dropped } = inbox.take(undamaged);
    expect(dropped).toBe(7);
    expect(news[0]!.message).toBe(7);
    expect(inbox.take(undamaged).dropped).toBe(0);
  });
});
