// SPDX-License-Identifier: BSD-3-Clause
// The feed in a thread of its own. However busy the page's thread is, what comes is read at once, and the
// page is handed what is newest when it has time: one batch at a time, the next when it asks.
import { type Connection, Feed } from "./feed";
import { type Batch, Inbox } from "./inbox";

export type Order =
  | { readonly kind: "connect"; readonly url: string }
  | { readonly kind: "disconnect" }
  | { readonly kind: "want" | "release"; readonly topic: string }
  /** The page has taken in what it was handed. */
  | { readonly kind: "ready" };

export type Report =
  | { readonly kind: "batch"; readonly batch: Batch }
  | { readonly kind: "connection"; readonly connection: Connection; readonly attempt: number }
  | { readonly kind: "trouble"; readonly sentence: string };

export class FeedServer {
  #feed: Feed | undefined;
  #inbox = new Inbox();
  #wanted = new Map<string, () => void>();
  #pageIsReady = true;
  #anythingNew = false;

  constructor(private readonly send: (report: Report) => void) {}

  obey(order: Order): void {
    if (order.kind === "connect") this.#connect(order.url);
    else if (order.kind === "disconnect") this.#feed?.disconnect();
    else if (order.kind === "want") this.#want(order.topic);
    else if (order.kind === "release") this.#release(order.topic);
    else this.#ready();
  }

  #connect(url: string): void {
    this.#feed = new Feed(url, {
      arrival: (arrival) => (this.#inbox.put(arrival), this.#changed()),
      time: (monitor_ms) => (this.#inbox.told(monitor_ms), this.#changed()),
      connection: (connection, attempt) => this.#connected(connection, attempt),
      trouble: (sentence) => this.send({ kind: "trouble", sentence }),
    });
    this.#feed.connect();
  }

  #connected(connection: Connection, attempt: number): void {
    // What waits is told before the connection that brought it is over.
    if (connection === "lost") this.#handOver();
    if (connection === "connecting") this.#inbox.clear();
    this.send({ kind: "connection", connection, attempt });
  }

  #want(topic: string): void {
    if (!this.#wanted.has(topic) && this.#feed) this.#wanted.set(topic, this.#feed.want(topic));
  }

  #release(topic: string): void {
    this.#wanted.get(topic)?.();
    this.#wanted.delete(topic);
  }

  #ready(): void {
    this.#pageIsReady = true;
    if (this.#anythingNew) this.#handOver();
  }

  #changed(): void {
    this.#anythingNew = true;
    if (this.#pageIsReady) this.#handOver();
  }

  #handOver(): void {
    const batch = this.#inbox.take((topic, reason) =>
      this.send({ kind: "trouble", sentence: `a message on ${topic} was damaged: ${reason}` }),
    );
    [this.#pageIsReady, this.#anythingNew] = [false, false];
    this.send({ kind: "batch", batch });
  }
}
