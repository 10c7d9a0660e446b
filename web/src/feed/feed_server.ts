// SPDX-License-Identifier: BSD-3-Clause
// The feed in a thread of its own. However busy the page's thread is, what comes is read at once, and the
// page is handed what is newest when it has time: one batch at a time, the next when it asks.
import { type Arrival, type Connection, Feed } from "./feed";
import { type Batch, Inbox } from "./inbox";
import { type DecodedPicture, PictureDecoder } from "./picture_decoder";
import { isPictureTopic } from "./topics";

export type Order =
  | { readonly kind: "connect"; readonly url: string }
  | { readonly kind: "disconnect" }
  | { readonly kind: "want" | "release"; readonly topic: string }
  /** The robot that the page shows whole. */
  | { readonly kind: "watch"; readonly robot: string | undefined }
  /** The page has taken in what it was handed. */
  | { readonly kind: "ready" }
  /** The page has drawn the picture that it was handed. */
  | { readonly kind: "shown"; readonly topic: string };

export type Report =
  | { readonly kind: "batch"; readonly batch: Batch }
  | { readonly kind: "picture"; readonly picture: DecodedPicture }
  | { readonly kind: "connection"; readonly connection: Connection; readonly attempt: number }
  | { readonly kind: "trouble"; readonly sentence: string };

export class FeedServer {
  #feed: Feed | undefined;
  #inbox = new Inbox();
  #pictures: PictureDecoder;
  #wanted = new Map<string, () => void>();
  #pageIsReady = true;
  /** Until what waits is due. */
  #wait: ReturnType<typeof setTimeout> | undefined;

  /** `send` hands over what stands in `transfer` rather than copies it. `bitmapOf` decodes a picture. */
  constructor(
    private readonly send: (report: Report, transfer?: Transferable[]) => void,
    bitmapOf?: (picture: Blob) => Promise<ImageBitmap>,
  ) {
    const trouble = (sentence: string) => send({ kind: "trouble", sentence });
    this.#pictures = new PictureDecoder({ trouble, picture: (picture) => send({ kind: "picture", picture }, [picture.bitmap]) }, bitmapOf);
  }

  obey(order: Order): void {
    if (order.kind === "connect") this.#connect(order.url);
    else if (order.kind === "disconnect") this.#feed?.disconnect();
    else if (order.kind === "want") this.#want(order.topic);
    else if (order.kind === "release") this.#release(order.topic);
    else if (order.kind === "watch") this.#inbox.lookAt(order.robot);
    else if (order.kind === "shown") this.#pictures.shown(order.topic);
    else this.#ready();
  }

  #connect(url: string): void {
    this.#feed = new Feed(url, {
      arrival: (arrival) => this.#arrived(arrival),
      time: (monitor_ms) => (this.#inbox.told(monitor_ms), this.#changed()),
      connection: (connection, attempt) => this.#connected(connection, attempt),
      trouble: (sentence) => this.send({ kind: "trouble", sentence }),
    });
    this.#feed.connect();
  }

  #arrived(arrival: Arrival): void {
    if (isPictureTopic(arrival.topic)) return this.#pictures.put(arrival);
    this.#inbox.put(arrival);
    this.#changed();
  }

  #connected(connection: Connection, attempt: number): void {
    // What waits is told before the connection that brought it is over.
    if (connection === "lost") this.#handOver(Infinity);
    if (connection === "connecting") this.#inbox.clear();
    this.send({ kind: "connection", connection, attempt });
  }

  #want(topic: string): void {
    if (!this.#wanted.has(topic) && this.#feed) this.#wanted.set(topic, this.#feed.want(topic));
  }

  #release(topic: string): void {
    this.#wanted.get(topic)?.();
    this.#wanted.delete(topic);
    this.#pictures.forget(topic);
  }

  #ready(): void {
    this.#pageIsReady = true;
    this.#changed();
  }

  #changed(): void {
    if (!this.#pageIsReady) return;
    const due_ms = this.#inbox.due_ms(performance.now());
    if (due_ms <= 0) this.#handOver();
    else if (due_ms < Infinity)
      this.#wait ??= setTimeout(() => {
        this.#wait = undefined;
        this.#changed();
      }, due_ms);
  }

  #handOver(now_ms = performance.now()): void {
    const damaged = (topic: string, reason: string) => this.send({ kind: "trouble", sentence: `a message on ${topic} was damaged: ${reason}` });
    const batch = this.#inbox.take(damaged, now_ms);
    this.#pageIsReady = false;
    this.send({ kind: "batch", batch });
  }
}
