// SPDX-License-Identifier: BSD-3-Clause
// What the panels see of a recording, from what the feed's thread reports.
import { beforeAll, expect, it, vi } from "vitest";
import type { Order, Report } from "../../src/feed/feed_server";
import type { News } from "../../src/feed/portions";
import { state, transition } from "./told";

const START_MS = Date.UTC(2024, 10, 28, 12);
const at = (after_s: number) => START_MS + after_s * 1000;
const ns = (after_s: number) => BigInt(at(after_s)) * 1_000_000n;

/** The feed's thread, as the test plays it. */
class FakeWorker {
  static orders: Order[] = [];
  static report: (report: Report) => void;
  onmessage: (event: { data: Report }) => void = () => {};
  constructor() {
    FakeWorker.report = (data) => this.onmessage({ data });
  }
  postMessage(order: Order) {
    FakeWorker.orders.push(order);
  }
}

const page = new URL("http://monitor/?recording=my%20run.mcap&at=20");
vi.stubGlobal("location", page);
vi.stubGlobal("self", { location: page });
vi.stubGlobal("sessionStorage", { getItem: () => null });
vi.stubGlobal("matchMedia", () => ({ matches: false, addEventListener: () => {} }));
vi.stubGlobal("requestAnimationFrame", (draw: () => void) => setTimeout(draw, 1));
vi.stubGlobal("Worker", FakeWorker);

const { live } = await import("../../src/model/live.svelte");
const { showInstant, axis } = await import("../../src/model/time_axis.svelte");

const stateAt = (after_s: number, name: string, robot = "io"): News => ({ topic: `/${robot}/state`, message: state({ at_ms: at(after_s), state: name, robot }), received_ms: at(after_s), count: 1 });
const tell = (told_s: number, ...news: News[]) => FakeWorker.report({ kind: "batch", batch: { told_ms: at(told_s), news, dropped: 0 } });
const answer = (after_s: number) => FakeWorker.report({ kind: "playback", isBorder: true, state: { status: "playing", now_ns: ns(after_s), speed: 1, sought: true, id: "page 1" } });
/** Of one moment. */
const shown = () => ({ at_s: (live.present_ms - START_MS) / 1000, states: live.robots.map(({ name, state: told }) => [name, told?.value.state]), silent: [...live.silent] });
const until = (wanted: object) => vi.waitFor(() => expect(shown()).toEqual(wanted), { timeout: 20_000 });

let openedAt_s = 0;
beforeAll(() => {
  live.start();
  FakeWorker.report({ kind: "begun", range: { start_ns: ns(0), end_ns: ns(60) }, now_ns: ns(20) });
  openedAt_s = shown().at_s;
});

it("is asked for where it is played, from where the address says", () => {
  expect(FakeWorker.orders[0]).toEqual({ kind: "connect", url: "ws://monitor/replay?recording=my%20run.mcap", playback: { at_s: 20 } });
});

it("never shows the time of today", () => {
  expect(openedAt_s).toBe(20);
});

it("has the recording's time, by which a robot is silent", async () => {
  tell(20, stateAt(20, "wander"), stateAt(17, "grab", "callisto"));
  await until({ at_s: 20, states: [["io", "wander"], ["callisto", "grab"]], silent: ["callisto"] });
  expect([live.isBehind, live.now, live.isPast]).toEqual([false, "", false]);
  tell(25);
  await until({ at_s: 25, states: [["io", "wander"], ["callisto", "grab"]], silent: ["io", "callisto"] });
});

it("shows the instant before until it knows all of the next one, and then nothing of what was before", async () => {
  tell(25, { topic: "/io/transition", message: transition(1, "backup", at(25)), received_ms: at(25), count: 1 }, stateAt(25, "backup"));
  await until({ at_s: 25, states: [["io", "backup"], ["callisto", "grab"]], silent: ["callisto"] });
  showInstant(at(21));
  expect(FakeWorker.orders.at(-1)).toMatchObject({ kind: "play", request: { plays: true, seek_ns: ns(21) } });
  answer(21);
  expect(shown()).toEqual({ at_s: 25, states: [["io", "backup"], ["callisto", "grab"]], silent: ["callisto"] });
  tell(21, stateAt(20.9, "wander"));
  await until({ at_s: 21, states: [["io", "wander"], ["callisto", undefined]], silent: ["callisto"] });
  expect([live.robots[0]?.transitions, live.past.every(({ at_ms }) => at_ms <= at(21)), axis.follows]).toEqual([[], true, true]);
});

it("goes where a step leads, again and again, before the first is answered", async () => {
  const { playback } = live;
  const before = FakeWorker.orders.length;
  playback?.step(0.1);
  playback?.step(0.1);
  const asked = () => FakeWorker.orders.slice(before).flatMap((order) => (order.kind === "play" ? [order.request.seek_ns] : []));
  expect(asked()).toEqual([ns(21) + 100_000_000n]);
  answer(21.1);
  await vi.waitFor(() => expect(asked()).toEqual([ns(21) + 100_000_000n, ns(21) + 200_000_000n]));
});

it("tells that it was never opened, and asks no more when it is given up", () => {
  expect(live.isUnopened).toBe(false);
  live.giveUp("There is no recording my run.mcap.");
  expect([live.trouble, FakeWorker.orders.at(-1)]).toEqual(["There is no recording my run.mcap.", { kind: "disconnect" }]);
});
