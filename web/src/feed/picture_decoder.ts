// SPDX-License-Identifier: BSD-3-Clause
import type { Arrival } from "./feed";
import type { CompressedImage, Time } from "./messages";

/** A picture that is ready to be drawn. Whoever is handed it closes its bitmap. */
export interface DecodedPicture {
  readonly topic: string;
  readonly bitmap: ImageBitmap;
  /** When it was taken, by the robot's clock. */
  readonly taken: Time;
}

export interface PictureDecoderEvents {
  picture: (picture: DecodedPicture) => void;
  /** Something of a picture that the reader should know, in one sentence. */
  trouble: (sentence: string) => void;
}

/**
 * Decodes pictures, so that the page's own thread need not. Of each topic one is on its way at a time, until the page has
 * shown it, and the newest waits: a slow page misses pictures, but what it shows is never old.
 */
export class PictureDecoder {
  #waiting = new Map<string, Arrival>();
  #underWay = new Set<string>();
  /** How often each topic was forgotten: a picture that was begun before the last time is not wanted any more. */
  #forgotten = new Map<string, number>();

  constructor(
    private readonly events: PictureDecoderEvents,
    private readonly bitmapOf: (picture: Blob) => Promise<ImageBitmap> = (picture) => createImageBitmap(picture),
  ) {}

  put(arrival: Arrival): void {
    this.#waiting.set(arrival.topic, arrival);
    this.#begin(arrival.topic);
  }

  /** The page has drawn what it was handed of `topic`. */
  shown(topic: string): void {
    this.#underWay.delete(topic);
    this.#begin(topic);
  }

  /** Nobody looks at `topic` any more. */
  forget(topic: string): void {
    this.#waiting.delete(topic);
    this.#forgotten.set(topic, this.#timesForgotten(topic) + 1);
  }

  /** What was told is of another instant than what comes now. */
  forgetAll(): void {
    for (const topic of new Set([...this.#waiting.keys(), ...this.#underWay])) this.forget(topic);
  }

  #timesForgotten(topic: string): number {
    return this.#forgotten.get(topic) ?? 0;
  }

  #begin(topic: string): void {
    const arrival = this.#waiting.get(topic);
    if (!arrival || this.#underWay.has(topic)) return;
    this.#waiting.delete(topic);
    this.#underWay.add(topic);
    void this.#handOver(arrival);
  }

  async #handOver({ topic, decode }: Arrival): Promise<void> {
    const times = this.#timesForgotten(topic);
    const isWanted = () => this.#timesForgotten(topic) === times;
    let format = "";
    try {
      const image = decode() as CompressedImage;
      format = image.format;
      const type = format.includes("png") ? "image/png" : "image/jpeg";
      const bitmap = await this.bitmapOf(new Blob([image.data as Uint8Array<ArrayBuffer>], { type }));
      if (isWanted()) return this.events.picture({ topic, bitmap, taken: image.header.stamp });
      bitmap.close();
    } catch {
      if (isWanted()) this.events.trouble(`A ${format ? `${format} ` : ""}picture on ${topic} could not be drawn: it is damaged or of an unknown kind.`);
    }
    this.shown(topic);
  }
}
