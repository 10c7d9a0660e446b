// SPDX-License-Identifier: BSD-3-Clause
import type { Connection } from "./feed";
import type { Beginning, Order, Report } from "./feed_server";
import type { Batch } from "./inbox";
import type { DecodedPicture } from "./picture_decoder";
import type { PlaybackRequest, PlaybackState } from "./playback";
import type { Range } from "./playback_link";

export interface PageFeedEvents {
  batch: (batch: Batch) => void;
  /** It is drawn before this returns: its bitmap is closed after it. */
  picture: (picture: DecodedPicture) => void;
  connection: (connection: Connection, attempt: number) => void;
  /** Something of the feed that the reader should know, in one sentence. */
  trouble: (sentence: string) => void;
  /** A recording begins to play: what was handed over before is of another instant. */
  begun?: (range: Range, now_ns: bigint) => void;
  /** Where `isBorder`, what was handed over before is of another instant. */
  playback?: (state: PlaybackState, isBorder: boolean) => void;
}

/** The page's end of the feed, which runs in a thread of its own. */
export class PageFeed {
  #worker: Worker | undefined;
  #wanted = new Map<string, number>();
  #looked: string | undefined;

  constructor(
    private readonly url: string,
    private readonly events: PageFeedEvents,
    /** What is heard is a recording. */
    private readonly beginning?: Beginning,
  ) {}

  connect(): void {
    this.#worker = new Worker(new URL("./feed_worker.ts", import.meta.url), { type: "module" });
    this.#worker.onmessage = ({ data }: MessageEvent<Report>) => this.#reported(data);
    this.#worker.onerror = ({ message }) => this.events.trouble(`the page's reader failed (${message}): reload the page`);
    this.#order({ kind: "connect", url: this.url, playback: this.beginning });
    for (const topic of this.#wanted.keys()) this.#order({ kind: "want", topic });
  }

  /** For good. */
  disconnect(): void {
    this.#order({ kind: "disconnect" });
  }

  /** How a recording is to be played. */
  play(request: PlaybackRequest): void {
    this.#order({ kind: "play", request });
  }

  /** Reads `topic` until the returned function is called. */
  want(topic: string): () => void {
    const count = this.#wanted.get(topic) ?? 0;
    this.#wanted.set(topic, count + 1);
    if (count === 0) this.#order({ kind: "want", topic });
    return () => this.#release(topic);
  }

  /** Of this robot everything is told as it comes, however many there are. */
  lookAt(robot: string | undefined): void {
    if (robot === this.#looked) return;
    this.#looked = robot;
    this.#order({ kind: "watch", robot });
  }

  #release(topic: string): void {
    const count = (this.#wanted.get(topic) ?? 0) - 1;
    if (count > 0) {
      this.#wanted.set(topic, count);
      return;
    }
    this.#wanted.delete(topic);
    this.#order({ kind: "release", topic });
  }

  #reported(report: Report): void {
    if (report.kind === "connection") this.events.connection(report.connection, report.attempt);
    else if (report.kind === "trouble") this.events.trouble(report.sentence);
    else if (report.kind === "picture") this.#show(report.picture);
    else if (report.kind === "begun") this.events.begun?.(report.range, report.now_ns);
    else if (report.kind === "playback") this.events.playback?.(report.state, report.isBorder);
    else this.#take(report.batch);
  }

  #show(picture: DecodedPicture): void {
    try {
      this.events.picture(picture);
    } finally {
      picture.bitmap.close();
      this.#order({ kind: "shown", topic: picture.topic });
    }
  }

  #take(batch: Batch): void {
    try {
      this.events.batch(batch);
    } finally {
      this.#order({ kind: "ready" });
    }
  }

  #order(order: Order): void {
    this.#worker?.postMessage(order);
  }
}
