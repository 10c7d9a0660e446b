// SPDX-License-Identifier: BSD-3-Clause
import type { AddressInfo } from "node:net";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { WebSocket, WebSocketServer } from "ws";
import { type Connection, Feed } from "../../src/feed/feed";
import { schemaOf, writerOf } from "../fixture/idl.mjs";
import { state } from "../model/told";

vi.stubGlobal("WebSocket", WebSocket);

const STATE = "galilean_msgs/msg/RobotState";
const IMAGE = "sensor_msgs/msg/CompressedImage";
const channel = (id: number, topic: string, schemaName: string) => ({
  id, topic, schemaName, encoding: "cdr", schemaEncoding: "ros2idl", schema: schemaName.startsWith("other") ? "" : schemaOf(schemaName),
});

/** A monitor of one socket: what the page asks of it, and what it sends. */
class Monitor {
  asked: { op: string; subscriptions?: { id: number; channelId: number }[] }[] = [];
  #sockets = new WebSocketServer({ port: 0, handleProtocols: (offered) => [...offered][0] ?? false });
  #socket: WebSocket | undefined;
  constructor() {
    this.#sockets.on("connection", (socket) => {
      this.#socket = socket;
      socket.on("message", (text) => this.asked.push(JSON.parse(String(text))));
      this.tell({ op: "serverInfo", name: "galilean", capabilities: [] });
      this.tell({ op: "advertise", channels: [channel(1, "/io/state", STATE), channel(2, "/io/camera/compressed", IMAGE)] });
    });
  }
  get url() {
    return `ws://127.0.0.1:${(this.#sockets.address() as AddressInfo).port}`;
  }
  tell(message: object) {
    this.#socket?.send(JSON.stringify(message));
  }
  send(subscription: number, payload: Uint8Array) {
    const head = Buffer.alloc(13);
    head.writeUInt8(1);
    head.writeUInt32LE(subscription, 1);
    head.writeBigUInt64LE(BigInt(Date.now()) * 1_000_000n, 5);
    this.#socket?.send(Buffer.concat([head, payload]));
  }
  subscription(channelId: number) {
    return this.asked.flatMap(({ subscriptions = [] }) => subscriptions).find((each) => each.channelId === channelId)?.id;
  }
  drop() {
    this.#socket?.terminate();
  }
  close() {
    this.drop();
    this.#sockets.close();
  }
}

/** A slow machine is no mistake of the feed. */
const until = (holds: () => boolean): Promise<boolean> => vi.waitUntil(holds, { timeout: 20_000 });

describe("the feed", () => {
  let monitor: Monitor;
  let connections: Connection[];
  let heard: [string, unknown][];
  let troubles: string[];
  let feed: Feed;
  beforeEach(() => {
    [monitor, connections, heard, troubles] = [new Monitor(), [], [], []];
    feed = new Feed(monitor.url, {
      message: (topic, message) => heard.push([topic, message]),
      connection: (connection) => connections.push(connection),
      trouble: (sentence) => troubles.push(sentence),
    });
    feed.connect();
  });
  afterEach(() => {
    feed.disconnect();
    monitor.close();
  });

  it("decodes what robots tell, unasked", async () => {
    await until(() => monitor.subscription(1) !== undefined);
    monitor.send(monitor.subscription(1)!, writerOf(STATE)(state({ state: "grab_trash" })));
    await until(() => heard.length > 0);
    expect(heard[0]).toMatchObject(["/io/state", { robot: "io", state: "grab_trash" }]);
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
  it("survives a damaged message and a schema that it cannot read", async () => {
    await until(() => monitor.subscription(1) !== undefined);
    monitor.tell({ op: "advertise", channels: [{ ...channel(3, "/ganymede/state", "other/msg/State"), schema: "no IDL" }] });
    monitor.send(monitor.subscription(1)!, new Uint8Array([0, 1, 0, 0, 9]));
    await until(() => troubles.length >= 2);
    expect(troubles.join("\n")).toMatch(/\/ganymede\/state cannot be read[^]*\/io\/state was damaged/);
    monitor.send(monitor.subscription(1)!, writerOf(STATE)(state()));
    await until(() => heard.length > 0);
  });
});
