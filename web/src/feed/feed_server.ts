// SPDX-License-Identifier: BSD-3-Clause
// The feed in a thread of its own. However busy the page's thread is, what comes is read at once, and the
// page is handed what is newest when it has time: one batch at a time, the next when it asks. What happens goes at once:
// behind a page that draws it would wait for two of its turns.
import { type Arrival, type Connection, Feed } from "./feed";
import { type Batch, Inbox } from "./inbox";
import { type DecodedPicture, PictureDecoder } from "./picture_decoder";
import type { PlaybackRequest, PlaybackState } from "./playback";
import { PlaybackLink, type Range } from "./playback_link";
import { isPictureTopic } from "./topics";

/** Where a recording begins to play. */
export interface Beginning {
  readonly at_s?: number | undefined;
}

export type Order =
  | { readonly kind: "connect"; readonly url: string; readonly playback?: Beginning | undefined }
  | { readonly kind: "disconnect" }
  | { readonly kind: "want" | "release"; readonly topic: string }
  /** The robot that the page shows whole. */
  | { readonly kind: "watch"; readonly robot: string | undefined }
  | { readonly kind: "play"; readonly request: PlaybackRequest }
  /** The page has taken in a batch. */
  | { readonly kind: "ready" }
  /** The page has drawn the picture that it was handed. */
  | { readonly kind: "shown"; readonly topic: string };

export type Report =
  | { readonly kind: "batch"; readonly batch: Batch }
  | { readonly kind: "picture"; readonly picture: DecodedPicture }
  /** What was handed over before it is of another instant. */
  | { readonly kind: "begun"; readonly range: Range; readonly now_ns: bigint }
  /** Where `isBorder`, too. */
  | { readonly kind: "playback"; readonly state: PlaybackState; readonly isBorder: boolean }
  | { readonly kind: "connection"; readonly connection: Connection; readonly attempt: number }
  | { readonly kind: "trouble"; readonly sentence: string };

/** So many batches are on their way to a page at once: one, and one more where something has happened since. */
const ON_THEIR_WAY = { otherwise: 1, happened: 2 };

export class FeedServer {
  #feed: Feed | undefined;
  #playback: PlaybackLink | undefined;
  #inbox = new Inbox();
  #pictures: PictureDecoder;
  #wanted = new Map<string, () => void>();
  /** How many batches the page has not taken in yet. */
  #onTheirWay = 0;
  #isGathering = false;
  /** Until what waits is due. */
  #wait: ReturnType<typeof setTimeout> | undefined;

  /**
   * `send` hands over what stands in `transfer` rather than copies it. `bitmapOf` decodes a picture. `soon` calls back when
   * what has come already has been read.
   */
  constructor(
    private readonly send: (report: Report, transfer?: Transferable[]) => void,
    private readonly soon: (act: () => void) => void,
    bitmapOf?: (picture: Blob) => Promise<ImageBitmap>,
  ) {
    const trouble = (sentence: string) => send({ kind: "trouble", sentence });
    this.#pictures = new PictureDecoder({ trouble, picture: (picture) => send({ kind: "picture", picture }, [picture.bitmap]) }, bitmapOf);
  }

  obey(order: Order): void {
    if (order.kind === "connect") this.#connect(order.url, order.playback);
    else if (order.kind === "play") this.#playback?.ask(order.request);
    else if (order.kind === "disconnect") this.#feed?.disconnect();
    else if (order.kind === "want") this.#want(order.topic);
    else if (order.kind === "release") this.#release(order.topic);
    else if (order.kind === "watch") this.#inbox.lookAt(order.robot);
    else if (order.kind === "shown") this.#pictures.shown(order.topic);
    else this.#ready();
  }

  #connect(url: string, beginning?: Beginning): void {
    this.#inbox = new Inbox(beginning === undefined);
    const trouble = (sentence: string) => this.send({ kind: "trouble", sentence });
    this.#playback = beginning && new PlaybackLink({
      begun: (range, now_ns) => (this.#beginAnew(now_ns), this.send({ kind: "begun", range, now_ns })),
      state: (state, isBorder) => {
        if (isBorder) this.#beginAnew(state.now_ns);
        this.send({ kind: "playback", state, isBorder });
      },
      stuck: () => (trouble("The monitor has not answered where the recording is to go on from; it is asked again."), this.#feed?.reconnect()),
      trouble,
    }, beginning.at_s);
    this.#feed = new Feed(url, {
      arrival: (arrival) => this.#arrived(arrival),
      time: (monitor_ms) => (this.#inbox.told(monitor_ms), this.#gather()),
      connection: (connection, attempt) => this.#connected(connection, attempt),
      trouble,
    }, this.#playback);
    this.#feed.connect();
  }

  /** Nothing that waits is of the instant that comes now. What stood before it is told with the times that it had. */
  #beginAnew(now_ns: bigint): void {
    this.#inbox.clear();
    this.#inbox.told(Number(now_ns / 1000n) / 1000);
    this.#pictures.forgetAll();
  }

  #arrived(arrival: Arrival): void {
    if (isPictureTopic(arrival.topic)) return this.#pictures.put(arrival);
    this.#inbox.put(arrival);
    this.#gather();
  }

  #connected(connection: Connection, attempt: number): void {
    // What waits is told before the connection that brought it is over.
    if (connection === "lost") this.#handOverAll();
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
    this.#onTheirWay -= 1;
    this.#changed();
  }

  /** The monitor sends many messages at once: the first of them does not go alone, with the others behind it. */
  #gather(): void {
    if (this.#isGathering) return;
    this.#isGathering = true;
    this.soon(() => {
      this.#isGathering = false;
      this.#changed();
    });
  }

  #changed(): void {
    if (this.#onTheirWay >= (this.#inbox.hasHappened ? ON_THEIR_WAY.happened : ON_THEIR_WAY.otherwise)) return;
    const due_ms = this.#inbox.due_ms(performance.now());
    if (due_ms <= 0) this.#handOver(performance.now());
    else if (due_ms < Infinity)
      this.#wait ??= setTimeout(() => {
        this.#wait = undefined;
        this.#changed();
      }, due_ms);
  }

  #handOverAll(): void {
    do this.#handOver(Infinity);
    while (this.#inbox.due_ms(Infinity) <= 0);
  }

  #handOver(now_ms: number): void {
    const damaged = (topic: string, reason: string) => this.send({ kind: "trouble", sentence: `a message on ${topic} was damaged: ${reason}` });
    const batch = this.#inbox.take(damaged, now_ms);
    this.#onTheirWay += 1;
    this.send({ kind: "batch", batch });
  }
}
