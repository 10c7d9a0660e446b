// SPDX-License-Identifier: BSD-3-Clause
import { type Channel, FoxgloveClient, type MessageData, type Parameter, type ServerInfo, type SubscriptionId } from "@foxglove/ws-protocol";
import { ClockOffset } from "./clock_offset";
import { type Decode, decoderOf } from "./decoder";
import type { PlaybackLink } from "./playback_link";
import { isAlwaysWanted, LEASES, REPLAYED } from "./topics";

export type Connection = "connecting" | "live" | "lost";
/** A message as it came, which is decoded only where somebody looks at it. */
export interface Arrival {
  readonly topic: string;
  readonly decode: () => unknown;
  /** When the monitor received it, on the page's clock; of a recording: when it was received then. */
  readonly received_ms: number;
}

export interface FeedEvents {
  arrival: (arrival: Arrival) => void;
  /** The monitor's time, on the page's clock: it tells its time ten times a second. Of a recording: the time then. */
  time: (monitor_ms: number) => void;
  connection: (connection: Connection, attempt: number) => void;
  /** Something of the feed that the reader should know, in one sentence. */
  trouble: (sentence: string) => void;
}

const SUBPROTOCOLS = ["foxglove.sdk.v1", "foxglove.websocket.v1"];
const FIRST_RETRY_MS = 250;
const LONGEST_RETRY_MS = 500;
/** An answer that takes longer is none. */
const ANSWER_MS = 2000;
/** A connection without a word for one to two of these periods is dead, though nobody closed it. */
const DEAF_PERIOD_MS = 5000;

interface Subscription {
  channel: Channel;
  decode: Decode;
}

/** Whether there is anybody where the WebSocket `url` leads to. */
function isAnybodyThere(url: string): Promise<boolean> {
  const place = new URL("/", url.replace(/^ws/, "http"));
  return fetch(place, { method: "HEAD", cache: "no-store", signal: AbortSignal.timeout(ANSWER_MS) }).then(
    () => true,
    () => false,
  );
}

/**
 * The page's only socket: reads the monitor's topics by Foxglove's protocol, and connects again by itself,
 * also where the connection is dead without having been closed. Topics that cost something (pictures) are
 * read only while wanted.
 */
export class Feed {
  #client: FoxgloveClient | undefined;
  #clock: Pick<ClockOffset, "received_ms">;
  #channels = new Map<number, Channel>();
  #subscriptions = new Map<SubscriptionId, Subscription>();
  #decoders = new Map<string, Decode>();
  #wanted = new Map<string, number>();
  #attempt = 0;
  #retry: ReturnType<typeof setTimeout> | undefined;
  #watch: ReturnType<typeof setInterval> | undefined;
  /** Whether anything came since the connection was looked at last. */
  #heard = false;
  #isProbed = false;
  #ended = false;

  /** `playback`: what is heard at `url` is a recording, which has times of its own. */
  constructor(
    private readonly url: string,
    private readonly events: FeedEvents,
    private readonly playback?: PlaybackLink,
  ) {
    this.#clock = this.#newClock();
  }

  connect(): void {
    this.events.connection("connecting", this.#attempt);
    const socket = new WebSocket(this.playback?.addressOf(this.url) ?? this.url, SUBPROTOCOLS);
    const client = new FoxgloveClient({ ws: socket });
    this.#client = client;
    this.playback?.attach(socket);
    /** What is still said on a connection that was abandoned is not heard. */
    const whileCurrent = <A extends unknown[]>(act: (...said: A) => void) => (...said: A) => {
      if (this.#client === client) act(...said);
    };
    client.on("serverInfo", whileCurrent((info) => this.#begun(info)));
    client.on("advertise", whileCurrent((channels) => channels.forEach((channel) => this.#advertised(channel))));
    client.on("unadvertise", whileCurrent((ids) => ids.forEach((id) => this.#withdrawn(id))));
    client.on("message", whileCurrent((data) => this.#received(data)));
    client.on("time", whileCurrent(({ timestamp }) => this.events.time(this.#pageTime_ms(timestamp))));
    client.on("parameterValues", whileCurrent(({ parameters }) => parameters.forEach((each) => this.#set(each))));
    client.on("status", whileCurrent((status) => status.level > 0 && this.events.trouble(status.message)));
    client.on("error", () => {}); // a close follows, and tells the reader
    client.on("close", whileCurrent(({ reason }) => {
      if (this.playback && reason) this.events.trouble(reason);
      this.#closed();
    }));
  }

  /** Begins anew, since this connection is of no use. */
  reconnect(): void {
    const client = this.#client;
    if (!client) return;
    this.#closed();
    client.close();
  }

  /** Ends the connection, for good. */
  disconnect(): void {
    this.#ended = true;
    clearTimeout(this.#retry);
    clearInterval(this.#watch);
    this.#client?.close();
  }

  /** Reads `topic` until the returned function is called. */
  want(topic: string): () => void {
    this.#wanted.set(topic, (this.#wanted.get(topic) ?? 0) + 1);
    for (const channel of this.#channels.values()) if (channel.topic === topic) this.#subscribe(channel);
    return () => this.#release(topic);
  }

  #release(topic: string): void {
    const count = (this.#wanted.get(topic) ?? 0) - 1;
    if (count > 0) this.#wanted.set(topic, count);
    else {
      this.#wanted.delete(topic);
      this.#unsubscribe((channel) => channel.topic === topic);
    }
  }

  #advertised(channel: Channel): void {
    this.#channels.set(channel.id, channel);
    if (isAlwaysWanted(channel.topic) || this.#wanted.has(channel.topic)) this.#subscribe(channel);
  }

  #withdrawn(id: number): void {
    this.#channels.delete(id);
    for (const [key, { channel }] of this.#subscriptions) if (channel.id === id) this.#subscriptions.delete(key);
  }

  #subscribe(channel: Channel): void {
    if ([...this.#subscriptions.values()].some((known) => known.channel.id === channel.id)) return;
    const decode = this.#decoder(channel);
    if (!decode || !this.#client) return;
    this.#subscriptions.set(this.#client.subscribe(channel.id), { channel, decode });
  }

  #unsubscribe(which: (channel: Channel) => boolean): void {
    for (const [id, { channel }] of this.#subscriptions) {
      if (!which(channel)) continue;
      this.#subscriptions.delete(id);
      this.#client?.unsubscribe(id);
    }
  }

  #decoder({ topic, schemaName, schema, schemaEncoding, encoding }: Channel): Decode | undefined {
    const known = this.#decoders.get(schemaName);
    if (known) return known;
    try {
      if (encoding !== "cdr") throw new Error(`its encoding is ${encoding}, not cdr`);
      const decode = decoderOf(schemaName, schema, schemaEncoding);
      this.#decoders.set(schemaName, decode);
      return decode;
    } catch (error) {
      this.events.trouble(`${topic} cannot be read: ${(error as Error).message}`);
      return undefined;
    }
  }

  #received({ subscriptionId, timestamp, data }: MessageData): void {
    const received_ms = this.#pageTime_ms(timestamp);
    const subscription = this.#subscriptions.get(subscriptionId);
    if (!subscription) return;
    this.events.arrival({ topic: subscription.channel.topic, decode: () => subscription.decode(data), received_ms });
  }

  #pageTime_ms(timestamp_ns: bigint): number {
    this.#heard = true;
    return this.#clock.received_ms(Number(timestamp_ns / 1000n) / 1000, Date.now());
  }

  #newClock(): Pick<ClockOffset, "received_ms"> {
    return this.playback ? { received_ms: (recorded_ms) => recorded_ms } : new ClockOffset();
  }

  /** A parameter has no time of its own, and tells nothing of what else is known. */
  #set({ name, value }: Parameter): void {
    if (name === REPLAYED || name === LEASES) this.events.arrival({ topic: name, decode: () => value, received_ms: 0 });
  }

  #askForParameters(): void {
    this.#client?.subscribeParameterUpdates([REPLAYED, LEASES]);
    this.#client?.getParameters([REPLAYED, LEASES]);
  }

  #begun(info: ServerInfo): void {
    this.#attempt = 0;
    this.#heard = true;
    this.playback?.begun(info as object);
    if (info.capabilities.includes("parametersSubscribe")) this.#askForParameters();
    this.#watch = setInterval(() => this.#lookWhetherHeard(), DEAF_PERIOD_MS);
    this.events.connection("live", 0);
  }

  /** A dead connection may take minutes to close, for which nobody waits. A recording that stands still is asked first. */
  #lookWhetherHeard(): void {
    const [heard, isProbed] = [this.#heard || this.playback?.takeHeard() === true, this.#isProbed];
    [this.#heard, this.#isProbed] = [false, !heard && this.playback !== undefined && !isProbed];
    if (this.#isProbed) this.playback?.probe();
    else if (!heard) this.reconnect();
  }

  #closed(): void {
    clearInterval(this.#watch);
    this.playback?.closed();
    this.#client = undefined;
    this.#channels.clear();
    this.#subscriptions.clear();
    this.#decoders.clear();
    this.#clock = this.#newClock();
    if (this.#ended) return;
    this.#attempt += 1;
    this.events.connection("lost", this.#attempt);
    this.#tryAgainIn(Math.min(FIRST_RETRY_MS * 2 ** (this.#attempt - 1), LONGEST_RETRY_MS));
  }

  /** Asks by HTTP first: a browser holds back the next WebSocket for seconds once a dozen have failed. */
  #tryAgainIn(wait_ms: number): void {
    this.#retry = setTimeout(async () => {
      const isThere = await isAnybodyThere(this.url);
      if (this.#ended) return;
      if (isThere) this.connect();
      else this.#tryAgainIn(LONGEST_RETRY_MS);
    }, wait_ms);
  }
}
