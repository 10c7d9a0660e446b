// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { CROWD, GLANCE_MS, Inbox } from "../../src/feed/inbox";

const undamaged = () => expect.unreachable("nothing is damaged");

function arrival(topic: string, message: unknown, received_ms: number, decoded: unknown[] = []) {
  return { topic, received_ms, decode: () => (decoded.push(message), message) };
}

describe("what came since the page looked last", () => {
  it("is the newest of what tells how things stand, and how many there were; the rest is not even decoded", () => {
    const inbox = new Inbox();
    const decoded: unknown[] = [];
    for (let i = 1; i <= 600; ++i) inbox.put(arrival("/io/state", i, i * 100, decoded));
    expect(inbox.take(undamaged, Infinity).news).toEqual([{ topic: "/io/state", message: 600, received_ms: 60_000, count: 600 }]);
    expect(decoded).toEqual([600]);
  });
  it("is all that happened, in the order in which it came", () => {
    const inbox = new Inbox();
    inbox.put(arrival("/io/state", "before", 1));
    inbox.put(arrival("/io/transition", "first", 2));
    inbox.put(arrival("/io/transition", "second", 3));
    inbox.put(arrival("/io/state", "after", 4));
    inbox.put(arrival("/team/push_progress", "third", 5));
    expect(inbox.take(undamaged, Infinity).news.map(({ message }) => message)).toEqual(["first", "second", "after", "third"]);
  });
  it("is told once", () => {
    const inbox = new Inbox();
    inbox.put(arrival("/io/state", "once", 1));
    inbox.take(undamaged, Infinity);
    expect(inbox.take(undamaged, Infinity).news).toEqual([]);
  });
  it("says when a robot told no state, also where the page slept, and nothing of what another connection brought", () => {
    const inbox = new Inbox();
    const state = (received_ms: number) => inbox.put(arrival("/io/state", received_ms, received_ms));
    const pauses = () => inbox.take(undamaged, Infinity).news.map((news) => news.pauses);
    [1000, 2000, 15_000, 16_000, 20_000, 20_100].forEach(state);
    expect(pauses()).toEqual([[{ from_ms: 2000, to_ms: 15_000 }, { from_ms: 16_000, to_ms: 20_000 }]]);
    state(20_200);
    expect(pauses()).toEqual([undefined]);
    inbox.clear();
    state(90_000);
    expect(pauses()).toEqual([undefined]);
  });
  it("says until when the monitor told it, also where it told of nothing but the time", () => {
    const inbox = new Inbox();
    inbox.put(arrival("/io/state", "a", 1000));
    expect(inbox.take(undamaged, Infinity).told_ms).toBe(1000);
    inbox.told(1100);
    expect(inbox.take(undamaged, Infinity).told_ms).toBe(1100);
  });
  it("names what is damaged and keeps the rest", () => {
    const inbox = new Inbox();
    inbox.put({ topic: "/io/state", received_ms: 1, decode: () => { throw new Error("too short"); } });
    inbox.put(arrival("/io/variables", "whole", 2));
    const damage: string[] = [];
    const { news } = inbox.take((topic, reason) => damage.push(`${topic}: ${reason}`), 0);
    expect(damage).toEqual(["/io/state: too short"]);
    expect(news.map(({ message }) => message)).toEqual(["whole"]);
  });
  it("counts the events that a page could not take in for hours", () => {
    const inbox = new Inbox();
    for (let i = 0; i < 20_007; ++i) inbox.put(arrival("/io/transition", i, i));
    const { news, dropped } = inbox.take(undamaged, Infinity);
    expect(dropped).toBe(7);
    expect(news[0]!.message).toBe(7);
  });
  it("is of a crowd only what happened, and the robot that is looked at, until the others are due", () => {
    const inbox = new Inbox();
    const names = Array.from({ length: CROWD + 1 }, (_, i) => `r${i}`);
    const tellAll = (what: string) => names.forEach((name) => inbox.put(arrival(`/${name}/state`, `${name} ${what}`, 1)));
    const taken = (now_ms: number) => inbox.take(undamaged, now_ms).news.map(({ message, count }) => `${message} × ${count}`);
    inbox.lookAt("r3");
    tellAll("first");
    expect(taken(1000)).toHaveLength(names.length);
    tellAll("second");
    inbox.put(arrival("/r5/transition", "r5 grabs", 2));
    inbox.put(arrival("/team/objects", "objects", 2));
    expect(taken(1100)).toEqual(["r3 second × 1", "r5 grabs × 1", "objects × 1"]);
    tellAll("third");
    expect(taken(1200)).toEqual(["r3 third × 1"]);
    expect(taken(1000 + GLANCE_MS)).toEqual(names.filter((name) => name !== "r3").map((name) => `${name} third × 2`));
  });
  it("is of a larger crowd in turns, of whoever waits longest, and of everybody four times a second", () => {
    const inbox = new Inbox();
    const names = Array.from({ length: 3 * CROWD }, (_, i) => `r${i}`);
    const tellAll = () => names.forEach((name) => inbox.put(arrival(`/${name}/state`, name, 1)));
    tellAll(); // the first of them when nobody knew yet that they are a crowd
    inbox.take(undamaged, 1000);
    const turns: unknown[][] = [];
    for (let now_ms = 1001; now_ms < 1000 + 1.1 * GLANCE_MS; now_ms += 1) {
      tellAll();
      if (inbox.due_ms(now_ms) === 0) turns.push(inbox.take(undamaged, now_ms).news.map(({ message }) => message));
    }
    expect(turns.map(({ length }) => length)).toEqual([CROWD, CROWD, CROWD]);
    expect(turns.flat().sort()).toEqual([...names].sort());
  });
  it("is of everybody who had a turn meanwhile where the page comes seldom, so that nobody looks silent", () => {
    const inbox = new Inbox();
    const names = Array.from({ length: 3 * CROWD }, (_, i) => `r${i}`);
    const tellAll = () => names.forEach((name) => inbox.put(arrival(`/${name}/state`, name, 1)));
    tellAll();
    inbox.take(undamaged, 1000);
    const toldAfter = (now_ms: number) => (tellAll(), inbox.take(undamaged, now_ms).news.length);
    expect(toldAfter(1000 + (2 * GLANCE_MS) / 3 + 1)).toBe(2 * CROWD);
    expect(toldAfter(3000)).toBe(3 * CROWD);
  });
  it("says when it has to be looked at", () => {
    const inbox = new Inbox();
    expect(inbox.due_ms(0)).toBe(Infinity);
    inbox.told(1);
    expect(inbox.due_ms(0)).toBe(0);
    inbox.take(undamaged, 0);
    expect(inbox.due_ms(0)).toBe(Infinity);
    inbox.put(arrival("/io/state", "a", 1));
    expect(inbox.due_ms(0)).toBe(0);
  });
  it("tells of a robot of the crowd as soon as it is looked at", () => {
    const inbox = new Inbox();
    const names = Array.from({ length: 2 * CROWD }, (_, i) => `r${i}`);
    const tellAll = () => names.forEach((name) => inbox.put(arrival(`/${name}/state`, name, 1)));
    tellAll();
    inbox.take(undamaged, 1000);
    tellAll();
    inbox.lookAt("r20");
    expect(inbox.take(undamaged, 1001).news.map(({ message }) => message)).toContain("r20");
  });
  it("is of a small team always all", () => {
    const inbox = new Inbox();
    for (const now_ms of [1000, 1001, 1002]) {
      inbox.put(arrival("/io/state", now_ms, now_ms));
      inbox.put(arrival("/callisto/state", now_ms, now_ms));
      expect(inbox.take(undamaged, now_ms).news).toHaveLength(2);
    }
  });
});
