// SPDX-License-Identifier: BSD-3-Clause
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { WebSocket } from "ws";
import { FeedServer, type Report } from "../../src/feed/feed_server";
import type { RobotState } from "../../src/feed/messages";
import { writerOf } from "../fixture/idl.mjs";
import { state, transition } from "../model/told";
import { channel, FakeMonitor, STATE } from "./fake_monitor";

vi.stubGlobal("WebSocket", WebSocket);

const TRANSITION = "galilean_msgs/msg/Transition";
const until = (holds: () => boolean): Promise<boolean> => vi.waitUntil(holds, { timeout: 20_000 });

describe("the feed in a thread of its own", () => {
  let monitor: FakeMonitor;
  let reports: Report[];
  let server: FeedServer;
  /** What is to be done soon, where a test holds it back. */
  let held: (() => void)[] | undefined;
  const batches = () => reports.flatMap((report) => (report.kind === "batch" ? report.batch : []));
  const states = () => batches().flatMap(({ news }) => news.map(({ message, count }) => [(message as RobotState).state, count]));
  const sendState = (name: string) => monitor.send(monitor.subscription(1)!, writerOf(STATE)(state({ state: name })));
  beforeEach(async () => {
    [monitor, reports, held] = [new FakeMonitor(), [], undefined];
    server = new FeedServer((report) => reports.push(report), (act) => void (held ? held.push(act) : setImmediate(act)));
    server.obey({ kind: "connect", url: monitor.url });
    await until(() => monitor.subscription(1) !== undefined);
  });
  afterEach(() => {
    server.obey({ kind: "disconnect" });
    monitor.close();
  });

  it("hands over at once what comes while the page has time", async () => {
    sendState("wander");
    await until(() => states().length === 1);
    expect(states()).toEqual([["wander", 1]]);
  });
  it("hands nothing over while the page is busy, and then only what is newest", async () => {
    sendState("wander");
    await until(() => states().length === 1);
    for (const name of ["grab", "backup", "remember"]) sendState(name);
    monitor.tell({ op: "status", level: 1, message: "all is sent" });
    await until(() => reports.some(({ kind }) => kind === "trouble"));
    expect(batches()).toHaveLength(1);
    server.obey({ kind: "ready" });
    expect(states()).toEqual([["wander", 1], ["remember", 3]]);
  });
  it("hands over together what came together", async () => {
    held = [];
    for (const name of ["wander", "grab"]) sendState(name);
    monitor.tell({ op: "status", level: 1, message: "all is sent" });
    await until(() => reports.some(({ kind }) => kind === "trouble"));
    expect([held.length, states()]).toEqual([1, []]);
    for (const act of held) act();
    expect(states()).toEqual([["grab", 2]]);
  });
  it("hands over what happens while the page is busy with one batch, and no third one", async () => {
    monitor.tell({ op: "advertise", channels: [channel(3, "/io/transition", TRANSITION)] });
    await until(() => monitor.subscription(3) !== undefined);
    const happen = (number: number) => monitor.send(monitor.subscription(3)!, writerOf(TRANSITION)(transition(number, "grab")));
    sendState("wander");
    await until(() => batches().length === 1);
    sendState("backup");
    happen(1);
    await until(() => batches().length === 2);
    expect(batches()[1]!.news.map(({ topic }) => topic)).toEqual(["/io/state", "/io/transition"]);
    happen(2);
    monitor.tell({ op: "status", level: 1, message: "all is sent" });
    await until(() => reports.some(({ kind }) => kind === "trouble"));
    expect(batches()).toHaveLength(2);
    server.obey({ kind: "ready" });
    expect(batches()).toHaveLength(3);
  });
  it("reads a picture until it is released", async () => {
    server.obey({ kind: "want", topic: "/io/camera/compressed" });
    await until(() => monitor.subscription(2) !== undefined);
    server.obey({ kind: "release", topic: "/io/camera/compressed" });
    await until(() => monitor.asked.some(({ op }) => op === "unsubscribe"));
  });
  it("tells of a damaged message and goes on", async () => {
    monitor.send(monitor.subscription(1)!, new Uint8Array([0, 1, 0, 0, 9]));
    await until(() => reports.some(({ kind }) => kind === "trouble"));
    expect(reports.find(({ kind }) => kind === "trouble")).toMatchObject({ sentence: expect.stringMatching(/^a message on \/io\/state was damaged/) });
    server.obey({ kind: "ready" });
    sendState("wander");
    await until(() => states().length === 1);
  });
  it("hands over what waits before it says that the connection is lost", async () => {
    sendState("wander");
    await until(() => states().length === 1);
    sendState("grab");
    monitor.tell({ op: "status", level: 1, message: "all is sent" });
    await until(() => reports.some(({ kind }) => kind === "trouble"));
    monitor.drop();
    await until(() => reports.some((report) => report.kind === "connection" && report.connection === "lost"));
    const lost = reports.findIndex((report) => report.kind === "connection" && report.connection === "lost");
    expect(reports[lost - 1]!.kind).toBe("batch");
  });
});
