// SPDX-License-Identifier: BSD-3-Clause
// A whole recording, as the fixture plays it, up to what the page is handed.
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from "vitest";
import { WebSocket } from "ws";
import { FeedServer, type Report } from "../../src/feed/feed_server";
import type { RobotState } from "../../src/feed/messages";
import { seconds } from "../../src/feed/parts";
import { Recordings } from "../fixture/recordings.mjs";

vi.stubGlobal("WebSocket", WebSocket);

const until = (holds: () => boolean): Promise<boolean> => vi.waitUntil(holds, { timeout: 20_000 });
const START_MS = Date.UTC(2024, 10, 28, 12);

describe("a recording of three robots", () => {
  let http: Server;
  let server: FeedServer;
  let reports: Report[];
  const news = () => reports.flatMap((report) => (report.kind === "batch" ? report.batch.news : []));
  const playbacks = () => reports.flatMap((report) => (report.kind === "playback" ? report : []));
  const at_s = (received_ms: number) => (received_ms - START_MS) / 1000;
  const play = (speed: number, seek_s?: number, plays = true) =>
    server.obey({ kind: "play", request: { plays, speed, seek_ns: seek_s === undefined ? undefined : BigInt((START_MS + seek_s * 1000) * 1e6), id: `${speed} ${seek_s}` } });

  // It is made when it is asked for first, which takes a slow machine some seconds.
  beforeAll(() => void new Recordings({}).list(), 60_000);
  beforeEach(async () => {
    const recordings = new Recordings({});
    http = createServer().on("upgrade", (request, line, head) => recordings.upgrade(request, line, head));
    await new Promise<void>((listening) => void http.listen(0, "127.0.0.1", listening));
    reports = [];
    server = new FeedServer((report) => {
      reports.push(report);
      if (report.kind === "batch") server.obey({ kind: "ready" });
    }, setImmediate);
    server.obey({ kind: "connect", url: `ws://127.0.0.1:${(http.address() as AddressInfo).port}/replay?recording=office.mcap`, playback: {} });
    await until(() => news().some(({ topic }) => topic === "/io/state"));
  });
  afterEach(async () => {
    server.obey({ kind: "disconnect" });
    http.closeAllConnections();
    await new Promise((closed) => http.close(closed));
  });

  it("goes back without a message of the time that it came from", async () => {
    play(10, 30);
    await until(() => news().some(({ received_ms }) => at_s(received_ms) > 31));
    const before = news().length;
    play(1, 10);
    await until(() => playbacks().filter(({ isBorder }) => isBorder).length === 2);
    const border = reports.map((report) => report.kind === "playback" && report.isBorder).lastIndexOf(true);
    await until(() => news().length > before && reports.slice(border).some(({ kind }) => kind === "batch"));
    const after = reports.slice(border).flatMap((report) => (report.kind === "batch" ? report.batch.news : []));
    expect(after.map(({ received_ms }) => at_s(received_ms)).filter((each_s) => each_s > 20)).toEqual([]);
  });
  it("tells of a robot that fell silent its last word, with the time that it had", async () => {
    play(1, 20, false);
    await until(() => playbacks().some(({ isBorder }) => isBorder));
    reports.length = 0;
    play(1, 20, false);
    await until(() => news().some(({ topic }) => topic === "/callisto/state"));
    const { message, received_ms } = news().find(({ topic }) => topic === "/callisto/state")!;
    expect(at_s(received_ms)).toBeLessThan(9);
    expect(seconds((message as RobotState).stamp) * 1000).toBeCloseTo(received_ms, -1);
  });
  it("ends, and says so", async () => {
    play(100, 38);
    await until(() => playbacks().some(({ state }) => state.status === "ended"));
    expect(at_s(Number(playbacks().at(-1)!.state.now_ns / 1_000_000n))).toBe(40);
  });
});
