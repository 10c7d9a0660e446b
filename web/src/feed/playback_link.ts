// SPDX-License-Identifier: BSD-3-Clause
import { isStateFrame, type PlaybackRequest, type PlaybackState, requestFrame, stateOf } from "./playback";

/** From its first message to its last, in ns since the epoch. */
export interface Range {
  readonly start_ns: bigint;
  readonly end_ns: bigint;
}

export interface PlaybackEvents {
  /** It begins to play, from that time on: what was heard before is of another instant. */
  begun: (range: Range, now_ns: bigint) => void;
  /** `isBorder`: what was heard before it is of another instant. */
  state: (state: PlaybackState, isBorder: boolean) => void;
  /** The connection is of no use any more: a seek was not answered. */
  stuck: () => void;
  trouble: (sentence: string) => void;
}

/** A seek takes a fifth of a second. */
const ANSWER_MS = 8000;

interface WireTime {
  readonly sec: number;
  readonly nsec: number;
}

/** What `serverInfo` says of a recording. */
export interface Played {
  readonly dataStartTime?: WireTime;
  readonly dataEndTime?: WireTime;
}

const ns = ({ sec, nsec }: WireTime): bigint => BigInt(sec) * 1_000_000_000n + BigInt(nsec);
const within = ({ start_ns, end_ns }: Range, at_ns: bigint): bigint => (at_ns < start_ns ? start_ns : at_ns > end_ns ? end_ns : at_ns);

const OPEN = 1;
/** Of a frame with the playback's time: opcode, u64. */
const [TIME, TIME_BYTES] = [2, 9];

/**
 * How the page steers a playback, over one socket after another. From the moment a seek is asked for until it is
 * answered, what comes is of the instant before and is not heard.
 */
export class PlaybackLink {
  #socket: WebSocket | undefined;
  /** The newest seek that has no answer yet. */
  #awaited: string | undefined;
  #patience: ReturnType<typeof setTimeout> | undefined;
  /** As the page wants it, on every connection. */
  #wanted: Pick<PlaybackRequest, "plays" | "speed"> = { plays: true, speed: 1 };
  /** What was asked for while there was nobody to ask. */
  #unsent: PlaybackRequest | undefined;
  #range: Range | undefined;
  #isHeard = false;
  /** Where it is, or is about to be; undefined before the first connection. */
  #now_ns: bigint | undefined;

  /** `at_s`: where the first connection begins, in seconds from the start. */
  constructor(
    private readonly events: PlaybackEvents,
    private readonly at_s?: number,
  ) {}

  /** `url` with where to begin. */
  addressOf(url: string): string {
    const at_s = this.#range && this.#now_ns !== undefined ? Number(this.#now_ns - this.#range.start_ns) / 1e9 : this.at_s;
    if (at_s === undefined) return url;
    const place = new URL(url);
    place.searchParams.set("at", String(at_s));
    return place.href;
  }

  /** Hears what comes on `socket` before whoever hears it now. */
  attach(socket: WebSocket): void {
    this.#socket = socket;
    const hear = socket.onmessage;
    socket.onmessage = (event) => {
      this.#isHeard = true;
      if (!(event.data instanceof ArrayBuffer) || this.#lets(event.data)) hear?.call(socket, event);
    };
  }

  /** The monitor has said what it plays. */
  begun({ dataStartTime, dataEndTime }: Played): void {
    if (!dataStartTime || !dataEndTime) return this.events.trouble("This monitor does not say from when to when the recording goes, so that it cannot be shown: update the monitor.");
    this.#range = { start_ns: ns(dataStartTime), end_ns: ns(dataEndTime) };
    this.#now_ns = within(this.#range, this.#now_ns ?? this.#range.start_ns + BigInt(Math.round((this.at_s ?? 0) * 1e9)));
    this.events.begun(this.#range, this.#now_ns);
    const { plays, speed } = this.#wanted;
    if (this.#unsent) this.#send(this.#unsent);
    else if (!plays || speed !== 1) this.#send({ plays, speed, id: "as it was" });
  }

  ask(request: PlaybackRequest): void {
    this.#wanted = { plays: request.plays, speed: request.speed };
    if (request.seek_ns !== undefined) this.#expect(request.id, request.seek_ns);
    this.#send(request);
  }

  /** Whether anything came since this was asked last. */
  takeHeard(): boolean {
    const isHeard = this.#isHeard;
    this.#isHeard = false;
    return isHeard;
  }

  /** Asks for an answer, where nothing comes while it stands still. */
  probe(): void {
    this.#send({ ...this.#wanted, id: "is anybody there" });
  }

  /** The socket is closed. A seek without an answer is where the next one begins. */
  closed(): void {
    this.#answered();
    this.#socket = this.#unsent = undefined;
  }

  #expect(id: string, seek_ns: bigint): void {
    this.#answered();
    [this.#awaited, this.#now_ns] = [id, seek_ns];
    this.#patience = setTimeout(() => this.events.stuck(), ANSWER_MS);
  }

  #answered(): void {
    clearTimeout(this.#patience);
    this.#awaited = undefined;
  }

  #send(request: PlaybackRequest): void {
    const isOpen = this.#socket?.readyState === OPEN;
    // A seek that waits is not forgotten for a request without one.
    this.#unsent = isOpen ? undefined : { ...request, seek_ns: request.seek_ns ?? this.#unsent?.seek_ns, id: request.seek_ns === undefined ? (this.#unsent?.id ?? request.id) : request.id };
    if (isOpen) this.#socket?.send(requestFrame(request));
  }

  /** Whether a frame is for the others to hear. */
  #lets(frame: ArrayBuffer): boolean {
    if (isStateFrame(frame)) this.#take(stateOf(frame));
    else if (this.#awaited === undefined) {
      if (frame.byteLength === TIME_BYTES && new DataView(frame).getUint8(0) === TIME) this.#now_ns = new DataView(frame).getBigUint64(1, true);
      return true;
    }
    return false;
  }

  #take(state: PlaybackState | undefined): void {
    if (!state) return this.events.trouble("What the monitor told of its playback makes no sense.");
    const isBorder = state.sought && (this.#awaited === undefined || state.id === this.#awaited);
    if (isBorder) this.#answered();
    if (this.#awaited === undefined) this.#now_ns = state.now_ns;
    this.events.state(state, isBorder);
  }
}
