// SPDX-License-Identifier: BSD-3-Clause
import { select } from "d3-selection";
import { type ZoomBehavior, zoom, zoomIdentity } from "d3-zoom";
import type { Bounds } from "./bounds";

const PX_PER_M = { least: 8, most: 1200 };

interface Place {
  readonly x_m: number;
  readonly y_m: number;
}

/** What a hand moves by itself is no hold on the floor. */
const isCarried = ({ target }: Event) => target instanceof Element && target.closest("[data-movable]") !== null;

/** What part of the floor a map shows: it fits what there is to see until somebody moves it. */
export class MapView {
  x_px = $state(0);
  y_px = $state(0);
  px_per_m = $state(60);
  /** Somebody moved it. */
  moved = $state(false);
  /** From metres on the floor, y up turned down, to pixels, as an SVG group takes it. */
  readonly transform: string = $derived(`translate(${this.x_px},${this.y_px}) scale(${this.px_per_m})`);
  #element: HTMLElement | undefined;
  #zoom: ZoomBehavior<HTMLElement, unknown>;

  /** `carried` is told when a hand pans it, not when it zooms. */
  constructor(carried: () => void = () => {}) {
    this.#zoom = zoom<HTMLElement, unknown>()
      .scaleExtent([PX_PER_M.least, PX_PER_M.most])
      .filter((event: MouseEvent) => !event.button && (event.type === "wheel" || (!event.ctrlKey && !isCarried(event))))
      .on("zoom", ({ transform, sourceEvent }) => {
        const panned = transform.k === this.px_per_m;
        [this.x_px, this.y_px, this.px_per_m] = [transform.x, transform.y, transform.k];
        if (!sourceEvent) return;
        this.moved = true;
        if (panned) carried();
      });
  }

  /** A Svelte attachment: makes the element pan and zoom. */
  attach = (element: HTMLElement): (() => void) => {
    this.#element = element;
    const selection = select(element);
    selection.call(this.#zoom).on("dblclick.zoom", null);
    this.#show(this.x_px, this.y_px, this.px_per_m);
    return () => selection.on(".zoom", null);
  };

  fit({ left_m, bottom_m, width_m, height_m }: Bounds, width_px: number, height_px: number): void {
    if (width_px <= 0 || height_px <= 0) return;
    const px_per_m = Math.min(width_px / width_m, height_px / height_m, 200);
    const x_px = width_px / 2 - (left_m + width_m / 2) * px_per_m;
    const y_px = height_px / 2 + (bottom_m + height_m / 2) * px_per_m;
    this.#show(x_px, y_px, px_per_m);
  }

  /** Brings a place into the middle. */
  centre({ x_m, y_m }: Place, width_px: number, height_px: number): void {
    this.#show(width_px / 2 - x_m * this.px_per_m, height_px / 2 + y_m * this.px_per_m, this.px_per_m);
  }

  by(factor: number): void {
    this.moved = true;
    if (this.#element) select(this.#element).call(this.#zoom.scaleBy, factor);
  }

  pan(x_px: number, y_px: number): void {
    this.moved = true;
    this.#show(this.x_px + x_px, this.y_px + y_px, this.px_per_m);
  }

  /** The place under a point of the element. */
  placeAt(x_px: number, y_px: number): Place {
    return { x_m: (x_px - this.x_px) / this.px_per_m, y_m: -(y_px - this.y_px) / this.px_per_m };
  }

  #show(x_px: number, y_px: number, px_per_m: number): void {
    if (this.#element) select(this.#element).call(this.#zoom.transform, zoomIdentity.translate(x_px, y_px).scale(px_per_m));
  }
}

const ROUND_M = [0.1, 0.2, 0.5, 1, 2, 5, 10];

/** The longest round length that takes no more than `longest_px`. */
export function scaleBar_m(px_per_m: number, longest_px: number): number {
  return ROUND_M.filter((length_m) => length_m * px_per_m <= longest_px).at(-1) ?? ROUND_M[0]!;
}
