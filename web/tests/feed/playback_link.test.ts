// SPDX-License-Identifier: BSD-3-Clause
// A recording, from the monitor's socket to what the page is handed.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { WebSocket } from "ws";
import { FeedServer, type Report } from "../../src/feed/feed_server";
import type { RobotState } from "../../src/feed/messages";
import { writerOf } from "../fixture/idl.mjs";
import { state } from "../model/told";
import { FakeMonitor, STATE } from "./fake_monitor";

vi.stubGlobal("WebSocket", WebSocket);

const until = (holds: () => boolean): Promise<boolean> => vi.waitUntil(holds, { timeout: 20_000 });
const START_MS = Date.UTC(2024, 10, 28, 12);
const at_ns = (at_ms: number) => BigInt(at_ms) * 1_000_000n;

describe("a recording that is played", () => {
  let monitor: FakeMonitor;
  let reports: Report[];
  let server: FeedServer;
  const batches = () => reports.flatMap((report) => (report.kind === "batch" ? report.batch : []));
  const told = () => batches().flatMap(({ news }) => news.map(({ message, received_ms }) => [(message as RobotState).state, received_ms - START_MS]));
  const sendState = (name: string, after_ms: number) => monitor.send(monitor.subscription(1)!, writerOf(STATE)(state({ state: name })), START_MS + after_ms);
  const seek = (after_ms: number, id: string) => server.obey({ kind: "play", request: { plays: true, speed: 1, seek_ns: at_ns(START_MS + after_ms), id } });
  const playbacks = () => reports.flatMap((report) => (report.kind === "playback" ? report : []));

  beforeEach(async () => {
    const seconds = (after_s: number) => ({ sec: START_MS / 1000 + after_s, nsec: 0 });
    [monitor, reports] = [new FakeMonitor({ dataStartTime: seconds(0), dataEndTime: seconds(60) }), []];
    server = new FeedServer((report) => {
      reports.push(report);
      if (report.kind === "batch") server.obey({ kind: "ready" });
    }, setImmediate);
    server.obey({ kind: "connect", url: `${monitor.url}/replay?recording=office.mcap`, playback: { at_s: 12.5 } });
    await until(() => monitor.subscription(1) !== undefined);
  });
  afterEach(() => {
    server.obey({ kind: "disconnect" });
    monitor.close();
  });

  it("begins where the address says, and has the times that it had", async () => {
    expect(monitor.paths).toEqual(["/replay?recording=office.mcap&at=12.5"]);
    expect(reports.find(({ kind }) => kind === "begun")).toMatchObject({ range: { start_ns: at_ns(START_MS), end_ns: at_ns(START_MS + 60_000) }, now_ns: at_ns(START_MS + 12_500) });
    sendState("wander", 12_600);
    await until(() => told().length > 0);
    expect(told()).toEqual([["wander", 12_600]]);
  });
  it("hears nothing of the instant before from a seek on until it is answered", async () => {
    seek(40_000, "a");
    await until(() => monitor.requests.length > 0);
    sendState("before", 12_700);
    monitor.sendTime(START_MS + 12_700);
    monitor.sendPlayback(0, START_MS + 40_000, true, "a");
    sendState("after", 39_900);
    await until(() => told().length > 0);
    expect(told()).toEqual([["after", 39_900]]);
    // What stood before the instant is told with its own time, and time does not go back for that.
    expect(batches().map(({ told_ms }) => told_ms)).toEqual(batches().map(() => START_MS + 40_000));
    expect(playbacks()).toMatchObject([{ isBorder: true, state: { now_ns: at_ns(START_MS + 40_000) } }]);
  });
  it("takes the answer to an earlier seek for no answer to the newest", async () => {
    seek(40_000, "a");
    seek(50_000, "b");
    await until(() => monitor.requests.length === 2);
    monitor.sendPlayback(0, START_MS + 40_000, true, "a");
    sendState("between", 40_000);
    monitor.sendPlayback(0, START_MS + 50_000, true, "b");
    sendState("after", 50_000);
    await until(() => told().length > 0);
    expect(told()).toEqual([["after", 50_000]]);
    expect(playbacks().map(({ isBorder }) => isBorder)).toEqual([false, true]);
  });
  it("goes on after a lost connection from where it was, and stands still if it did", async () => {
    server.obey({ kind: "play", request: { plays: false, speed: 2, id: "c" } });
    await until(() => monitor.requests.length === 1);
    monitor.sendTime(START_MS + 20_250);
    await until(() => batches().some(({ told_ms }) => told_ms === START_MS + 20_250));
    monitor.drop();
    await until(() => monitor.requests.length === 2);
    expect(monitor.paths[1]).toBe("/replay?recording=office.mcap&at=20.25");
    expect([...monitor.requests[1]!.subarray(0, 6)]).toEqual([3, 1, 0, 0, 0, 64]);
    expect(reports.filter(({ kind }) => kind === "begun")).toHaveLength(2);
  });
  it("asks first whether anybody is there while nothing comes", async () => {
    // Its watch began with the connection: one of a connection that begins now goes by the clock of the test.
    vi.useFakeTimers({ toFake: ["setInterval", "clearInterval"] });
    monitor.drop();
    await until(() => monitor.paths.length === 2);
    await until(() => reports.filter(({ kind }) => kind === "begun").length === 2);
    vi.advanceTimersByTime(10_000);
    await until(() => monitor.requests.length === 1);
    monitor.sendPlayback(1, START_MS + 12_500, false, "is anybody there");
    await until(() => playbacks().length === 1);
    vi.advanceTimersByTime(5000);
    expect(monitor.paths).toHaveLength(2);
    vi.advanceTimersByTime(10_000);
    vi.useRealTimers();
    await until(() => monitor.paths.length === 3);
  });
});
