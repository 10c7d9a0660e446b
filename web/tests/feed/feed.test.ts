// SPDX-License-Identifier: BSD-3-Clause
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { WebSocket } from "ws";
import { type Connection, Feed } from "../../src/feed/feed";
import { writerOf } from "../fixture/idl.mjs";
import { state } from "../model/told";
import { channel, FakeMonitor, STATE } from "./fake_monitor";

vi.stubGlobal("WebSocket", WebSocket);
const { fetch } = globalThis;

/** A slow machine is no mistake of the feed. */
const until = (holds: () => boolean): Promise<boolean> => vi.waitUntil(holds, { timeout: 20_000 });

describe("the feed", () => {
  let monitor: FakeMonitor;
  let connections: Connection[];
  let heard: [string, unknown][];
  let troubles: string[];
  let times: number[];
  let feed: Feed;
  beforeEach(() => {
    [monitor, connections, heard, troubles, times] = [new FakeMonitor(), [], [], [], []];
    feed = new Feed(monitor.url, {
      arrival: ({ topic, decode }) => heard.push([topic, decode()]),
      time: (monitor_ms) => times.push(monitor_ms),
      connection: (connection) => connections.push(connection),
      trouble: (sentence) => troubles.push(sentence),
    });
    feed.connect();
  });
  afterEach(() => {
    feed.disconnect();
    monitor.close();
    vi.stubGlobal("fetch", fetch);
  });

  it("decodes what robots tell, unasked", async () => {
    await until(() => monitor.subscription(1) !== undefined);
    monitor.send(monitor.subscription(1)!, writerOf(STATE)(state({ state: "grab_trash" })));
    await until(() => heard.length > 0);
    expect(heard[0]).toMatchObject(["/io/state", { robot: "io", state: "grab_trash" }]);
  });
  it("learns from the monitor which robots a recording plays, now and whenever that changes", async () => {
    const played = new FakeMonitor({ capabilities: ["parametersSubscribe"] });
    const names: unknown[] = [];
    const quiet = { time: () => {}, connection: () => {}, trouble: () => {} };
    const listener = new Feed(played.url, { ...quiet, arrival: ({ topic, decode, received_ms }) => names.push([topic, decode(), received_ms]) });
    listener.connect();
    await until(() => played.asked.some(({ op }) => op === "getParameters"));
    expect(played.asked.filter(({ op }) => op.includes("arameter"))).toEqual([
      { op: "subscribeParameterUpdates", parameterNames: ["/team.replayed", "/team.history_problem", "/team.map_problem", "/team.leases", "/team.filled"] },
      { op: "getParameters", parameterNames: ["/team.replayed", "/team.history_problem", "/team.map_problem", "/team.leases", "/team.filled"] },
    ]);
    for (const value of [["io"], []]) played.tell({ op: "parameterValues", parameters: [{ name: "/team.replayed", value }, { name: "/io.held", value: true }] });
    played.tell({ op: "parameterValues", parameters: [{ name: "/team.history_problem", value: "The disk is full." }] });
    await until(() => names.length === 3);
    expect(names).toEqual([["/team.replayed", ["io"], 0], ["/team.replayed", [], 0], ["/team.history_problem", "The disk is full.", 0]]);
    listener.disconnect();
    played.close();
    expect(monitor.asked.some(({ op }) => op.includes("arameter"))).toBe(false);
  });
  it("reads pictures only while somebody wants them", async () => {
    await until(() => monitor.subscription(1) !== undefined);
    expect(monitor.subscription(2)).toBeUndefined();
    const release = feed.want("/io/camera/compressed");
    const releaseToo = feed.want("/io/camera/compressed");
    await until(() => monitor.subscription(2) !== undefined);
    release();
    releaseToo();
    await until(() => monitor.asked.some(({ op }) => op === "unsubscribe"));
    expect(monitor.asked.filter(({ op }) => op === "unsubscribe")).toHaveLength(1);
  });
  it("connects again by itself and says so", async () => {
    await until(() => connections.includes("live"));
    monitor.drop();
    await until(() => connections.filter((connection) => connection === "live").length === 2);
    expect(connections).toEqual(["connecting", "live", "lost", "connecting", "live"]);
  });
  it("opens no WebSocket while nobody is there, since a browser would hold back the next ones", async () => {
    await until(() => connections.includes("live"));
    const asked = vi.fn().mockRejectedValue(new TypeError("refused"));
    vi.stubGlobal("fetch", asked);
    monitor.drop();
    await until(() => asked.mock.calls.length === 3);
    expect(connections).toEqual(["connecting", "live", "lost"]);
    asked.mockResolvedValue(new Response());
    await until(() => connections.at(-1) === "live");
    expect(connections).toEqual(["connecting", "live", "lost", "connecting", "live"]);
  });
  it("gives up a connection that is dead without having been closed", async () => {
    await until(() => connections.includes("live"));
    vi.useFakeTimers({ toFake: ["setInterval", "clearInterval"] });
    const second = new Feed(monitor.url, { arrival: () => {}, time: () => {}, trouble: () => {}, connection: (connection) => connections.push(connection) });
    connections.length = 0;
    second.connect();
    await until(() => connections.includes("live"));
    vi.advanceTimersByTime(5000);
    expect(connections).toEqual(["connecting", "live"]);
    vi.advanceTimersByTime(5000);
    expect(connections).toEqual(["connecting", "live", "lost"]);
    vi.useRealTimers();
    await until(() => connections.at(-1) === "live");
    second.disconnect();
  });
  it("tells the monitor's time on the page's clock", async () => {
    await until(() => connections.includes("live"));
    const began_ms = Date.now();
    monitor.sendTime(began_ms - 3_600_000);
    await until(() => times.length > 0);
    expect(times[0]).toBeGreaterThanOrEqual(began_ms);
    monitor.sendTime(began_ms - 3_600_000 - 40_000);
    await until(() => times.length > 1);
    expect(times[0]! - times[1]!).toBeCloseTo(40_000, 0);
  });
  it("survives a schema that it cannot read", async () => {
    await until(() => monitor.subscription(1) !== undefined);
    monitor.tell({ op: "advertise", channels: [{ ...channel(3, "/ganymede/state", "other/msg/State"), schema: "no IDL" }] });
    await until(() => troubles.length >= 1);
    expect(troubles).toEqual([expect.stringMatching(/^\/ganymede\/state cannot be read/)]);
    monitor.send(monitor.subscription(1)!, writerOf(STATE)(state()));
    await until(() => heard.length > 0);
  });
});
