// SPDX-License-Identifier: BSD-3-Clause
import type { PlaybackRequest, PlaybackState, PlaybackStatus } from "../feed/playback";
import type { Range } from "../feed/playback_link";

const ms = (at_ns: bigint): number => Number(at_ns / 1000n) / 1000;

/** A recording as it is played: where it is, how fast it goes, and what the reader wants of it. Seconds are from its start. */
export class Playback {
  /** Undefined until the monitor has opened it. */
  range = $state.raw<Range>();
  status = $state<PlaybackStatus>("buffering");
  speed = $state(1);
  /** Whether it is to play on from where it is. */
  #plays = $state(true);
  /** What was asked last and has no answer yet: it counts at once for who looks at the bar. */
  #seek_s = $state<number>();
  /** Where to go when that is answered: while the bar is dragged, one seek is under way at a time. */
  #next_s = $state<number>();
  #shown_ms = $state(0);
  #asked = 0;
  /** The newest time of the recording that was told of. It moves on as messages come, ahead of what is drawn. */
  now_ms = 0;

  constructor(
    readonly name: string,
    private readonly ask: (request: PlaybackRequest) => void,
  ) {}

  get start_ms(): number {
    return this.range ? ms(this.range.start_ns) : 0;
  }
  readonly duration_s: number = $derived(this.range ? Number(this.range.end_ns - this.range.start_ns) / 1e9 : 0);
  /** Where it is, or where it has been told to go. */
  readonly position_s: number = $derived(this.#next_s ?? this.#seek_s ?? this.#clamped((this.#shown_ms - this.start_ms) / 1000));
  /** The same as a time of that day. */
  readonly position_ms: number = $derived(this.start_ms + this.position_s * 1000);
  readonly plays: boolean = $derived(this.#plays && this.status !== "ended");

  /** From the end it plays from the start. */
  toggle(): void {
    if (this.status === "ended" && this.#seek_s === undefined) {
      this.#plays = true;
      return this.seek(0);
    }
    this.#plays = !this.plays;
    this.#request();
  }

  setSpeed(speed: number): void {
    this.speed = speed;
    this.#request();
  }

  seek(to_s: number): void {
    if (!this.range) return;
    if (this.#seek_s !== undefined) this.#next_s = this.#clamped(to_s);
    else this.#send(this.#clamped(to_s));
  }

  seekTo(at_ms: number): void {
    this.seek((at_ms - this.start_ms) / 1000);
  }

  /** It stands still then. */
  step(by_s: number): void {
    this.#plays = false;
    this.seek(this.position_s + by_s);
  }

  /** It was opened, or opened anew after the connection was lost: what was asked before is answered by that. */
  begun(range: Range, now_ns: bigint): void {
    this.range = range;
    this.status = this.#plays ? "playing" : "paused";
    this.now_ms = ms(now_ns);
  }

  /** `isBorder`: what was heard before is of another instant. */
  told({ status, now_ns }: PlaybackState, isBorder: boolean): void {
    this.status = status;
    if (isBorder) this.now_ms = ms(now_ns);
  }

  /** What is drawn is of that time. */
  drawn(at_ms: number): void {
    this.#shown_ms = at_ms;
  }

  /** The instant that it went to is drawn: it goes on to the one that was asked for meanwhile. */
  settled(): void {
    const to_s = this.#next_s;
    this.#seek_s = this.#next_s = undefined;
    if (to_s !== undefined) this.#send(to_s);
  }

  #send(to_s: number): void {
    this.status = this.#plays ? "playing" : "paused";
    this.#seek_s = to_s;
    this.#request(this.range!.start_ns + BigInt(Math.round(to_s * 1e9)));
  }

  #request(seek_ns?: bigint): void {
    this.#asked += 1;
    this.ask({ plays: this.#plays, speed: this.speed, seek_ns, id: `page ${this.#asked}` });
  }

  #clamped(at_s: number): number {
    return Math.min(Math.max(at_s, 0), this.duration_s);
  }
}
