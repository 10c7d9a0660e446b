// SPDX-License-Identifier: BSD-3-Clause
import type { Time } from "../feed/messages";
import { type Picture, pictureTopic } from "../feed/topics";
import { live } from "../model/live.svelte";
import type { PageFeed } from "../feed/page_feed";

const RATE_OVER = 10;

/** Draws one of a robot's pictures on a canvas as it comes; it is asked for no longer than it is read. */
export class PictureReader {
  width_px = $state(352);
  height_px = $state(186);
  count = $state(0);
  /** Since when pictures are asked for. */
  asked_ms = $state(0);
  shown_ms = $state(0);
  rate_hz = $state(0);
  /** When what is shown was taken, by the robot's clock. */
  taken = $state.raw<Time>();
  #times: number[] = [];
  #topic = "";

  /** Until the returned function is called; `drawn` is told of each one on the canvas. */
  read(feed: PageFeed, robot: string, picture: Picture, canvas: HTMLCanvasElement, drawn?: () => void): () => void {
    const topic = pictureTopic(robot, picture);
    if (topic !== this.#topic) this.#begin(topic);
    this.asked_ms = live.clock_ms;
    let release = feed.want(topic);
    // Asked for anew it is told at once, also where the recording stands still.
    const stay = live.onRewind(() => {
      this.#begin(topic);
      canvas.getContext("2d")?.clearRect(0, 0, canvas.width, canvas.height);
      release();
      release = feed.want(topic);
    });
    const silence = live.onPicture(topic, ({ bitmap, taken }) => {
      this.#show(bitmap, canvas);
      this.taken = taken;
      this.#counted();
      drawn?.();
    });
    return () => {
      release();
      stay();
      silence();
    };
  }

  /** What was read of another robot or picture says nothing of this one. */
  #begin(topic: string): void {
    this.#topic = topic;
    this.#times = [];
    [this.count, this.shown_ms, this.rate_hz, this.taken] = [0, 0, 0, undefined];
  }

  #show(bitmap: ImageBitmap, canvas: HTMLCanvasElement): void {
    if (canvas.width !== bitmap.width || canvas.height !== bitmap.height)
      [canvas.width, canvas.height] = [bitmap.width, bitmap.height];
    [this.width_px, this.height_px] = [bitmap.width, bitmap.height];
    canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
  }

  #counted(): void {
    this.count += 1;
    this.shown_ms = live.clock_ms;
    this.#times = [...this.#times, performance.now()].slice(-RATE_OVER);
    const [first, last] = [this.#times[0]!, this.#times.at(-1)!];
    if (last > first) this.rate_hz = ((this.#times.length - 1) * 1000) / (last - first);
  }
}
