// SPDX-License-Identifier: BSD-3-Clause
// Whom a page that has just been opened calls silent: what it is handed first may be minutes old.
import { beforeAll, describe, expect, it, vi } from "vitest";
import type { Report } from "../../src/feed/feed_server";
import type { News } from "../../src/feed/portions";
import { mapRobot, state } from "./told";

/** The feed's thread, as the test plays it. */
class FakeWorker {
  static report: (report: Report) => void;
  onmessage: (event: { data: Report }) => void = () => {};
  constructor() {
    FakeWorker.report = (data) => this.onmessage({ data });
  }
  postMessage() {}
}

/** Its messages come as the test's time goes on. */
class FakeChannel {
  port1: { onmessage?: () => void } = {};
  port2 = { postMessage: () => void setTimeout(() => this.port1.onmessage?.(), 0) };
}

vi.useFakeTimers();
vi.stubGlobal("MessageChannel", FakeChannel);
const page = new URL("http://monitor/");
vi.stubGlobal("location", page);
vi.stubGlobal("self", { location: page });
vi.stubGlobal("sessionStorage", { getItem: () => null });
vi.stubGlobal("matchMedia", () => ({ matches: false, addEventListener: () => {} }));
vi.stubGlobal("requestAnimationFrame", (draw: () => void) => setTimeout(draw, 1));
vi.stubGlobal("Worker", FakeWorker);

const { live } = await import("../../src/model/live.svelte");
const { alarmBoard } = await import("../../src/model/alarm_board.svelte");

const OLD_MS = 180_000;
const catalog = (robot: string): News => ({ topic: `/${robot}/catalog`, message: { json: "{}" }, received_ms: Date.now() - OLD_MS, count: 1 });
const stateOf = (robot: string): News => ({ topic: `/${robot}/state`, message: state({ robot, at_ms: Date.now() }), received_ms: Date.now(), count: 1 });
const tell = (told_ms: number, ...news: News[]) => FakeWorker.report({ kind: "batch", batch: { told_ms, news, dropped: 0 } });
const connected = (connection: "live" | "lost") => FakeWorker.report({ kind: "connection", connection, attempt: 0 });
/** Time goes on in tenths of a second; each of them is told of as `each` says. Returns all who were called silent meanwhile. */
function silentFor(duration_ms: number, each: () => void): string[] {
  const called = new Set<string>();
  for (let past_ms = 0; past_ms < duration_ms; past_ms += 100) {
    each();
    vi.advanceTimersByTime(100);
    alarmBoard.refresh();
    for (const name of live.silent) called.add(name);
    for (const { alarm } of alarmBoard.posted) if (alarm.kind === "silent") called.add(alarm.robot);
  }
  return [...called];
}

beforeAll(() => {
  live.start();
  connected("live");
});

describe("a page that is opened where robots have long been running", () => {
  it("calls none silent while it has not been told all", () => {
    tell(0, catalog("io"), catalog("callisto"));
    expect(silentFor(4000, () => tell(0))).toEqual([]);
    expect(live.robots.map(({ name }) => name)).toEqual(["io", "callisto"]);
  });
  it("nor by what is old, until it has listened for a while itself", () => {
    expect(silentFor(1500, () => tell(Date.now()))).toEqual([]);
    expect(silentFor(10_000, () => tell(Date.now(), stateOf("io"), stateOf("callisto")))).toEqual([]);
  });
  it("but one that falls silent after it", () => {
    expect(silentFor(1900, () => tell(Date.now(), stateOf("io")))).toEqual([]);
    expect(silentFor(1000, () => tell(Date.now(), stateOf("io")))).toEqual(["callisto"]);
    silentFor(1000, () => tell(Date.now(), stateOf("io"), stateOf("callisto")));
    alarmBoard.acknowledge();
  });
});

it("calls none silent when it is connected again, but whom the monitor calls so", () => {
  connected("lost");
  silentFor(60_000, () => {});
  connected("live");
  tell(Date.now());
  expect(silentFor(1000, () => tell(Date.now()))).toEqual([]);
  const objects = () => ({ topic: "/team/objects", message: { stamp: { sec: 0, nsec: 0 }, objects: [], robots: [mapRobot({ name: "callisto", silent: true, age_s: 40 })] }, received_ms: Date.now(), count: 1 });
  expect(silentFor(500, () => tell(Date.now(), stateOf("io"), objects()))).toEqual(["callisto"]);
});

it("calls none silent at an instant at which the page itself was behind", () => {
  const told_ms = Date.now();
  silentFor(10_000, () => tell(told_ms, { ...stateOf("io"), received_ms: told_ms }));
  live.instant_ms = Date.now() - 1000;
  expect(live.silent.has("io")).toBe(false);
  live.instant_ms = undefined;
});
