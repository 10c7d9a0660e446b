// SPDX-License-Identifier: BSD-3-Clause
import type { AddressInfo } from "node:net";
import { type WebSocket, WebSocketServer } from "ws";
import { schemaOf } from "../fixture/idl.mjs";

export const STATE = "galilean_msgs/msg/RobotState";
const IMAGE = "sensor_msgs/msg/CompressedImage";
export const channel = (id: number, topic: string, schemaName: string) => ({
  id, topic, schemaName, encoding: "cdr", schemaEncoding: "ros2idl", schema: schemaName.startsWith("other") ? "" : schemaOf(schemaName),
});

/** How a playback is answered. */
const STATE_OPCODE = 5;

/** A monitor of one socket: what the page asks of it, and what it sends. */
export class FakeMonitor {
  asked: { op: string; subscriptions?: { id: number; channelId: number }[] }[] = [];
  /** What was asked in binary frames. */
  requests: Buffer[] = [];
  /** Where each connection led to. */
  paths: string[] = [];
  #sockets = new WebSocketServer({ port: 0, handleProtocols: (offered) => [...offered][0] ?? false });
  #socket: WebSocket | undefined;
  /** `played` is what `serverInfo` says of a recording. */
  constructor(played: object = {}) {
    this.#sockets.on("connection", (socket, { url = "" }) => {
      this.#socket = socket;
      this.paths.push(url);
      socket.on("message", (data, isBinary) => (isBinary ? this.requests.push(data as Buffer) : this.asked.push(JSON.parse(String(data)))));
      this.tell({ op: "serverInfo", name: "galilean", capabilities: [], ...played });
      this.tell({ op: "advertise", channels: [channel(1, "/io/state", STATE), channel(2, "/io/camera/compressed", IMAGE)] });
    });
  }
  get url() {
    return `ws://127.0.0.1:${(this.#sockets.address() as AddressInfo).port}`;
  }
  tell(message: object) {
    this.#socket?.send(JSON.stringify(message));
  }
  send(subscription: number, payload: Uint8Array, at_ms = Date.now()) {
    const head = Buffer.alloc(13);
    head.writeUInt8(1);
    head.writeUInt32LE(subscription, 1);
    head.writeBigUInt64LE(BigInt(at_ms) * 1_000_000n, 5);
    this.#socket?.send(Buffer.concat([head, payload]));
  }
  sendTime(at_ms: number) {
    const frame = Buffer.alloc(9);
    frame.writeUInt8(2);
    frame.writeBigUInt64LE(BigInt(at_ms) * 1_000_000n, 1);
    this.#socket?.send(frame);
  }
  /** Status 0 plays, 1 stands still. */
  sendPlayback(status: number, at_ms: number, sought: boolean, id = "") {
    const frame = Buffer.alloc(19);
    frame.writeUInt8(STATE_OPCODE);
    frame.writeUInt8(status, 1);
    frame.writeBigUInt64LE(BigInt(at_ms) * 1_000_000n, 2);
    frame.writeFloatLE(1, 10);
    frame.writeUInt8(Number(sought), 14);
    frame.writeUInt32LE(Buffer.byteLength(id), 15);
    this.#socket?.send(Buffer.concat([frame, Buffer.from(id)]));
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
