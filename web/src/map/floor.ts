// SPDX-License-Identifier: BSD-3-Clause
// The floor and the trails on it, drawn on a canvas: there may be tens of thousands of points.

import type { OccupancyGrid } from "../feed/messages";
import type { Robot, TrailPoint } from "../model/model";
import { unknownSince } from "../model/trail";

/** Where the map's origin stands on the canvas, y down, in CSS pixels. */
export interface Ground {
  readonly x_px: number;
  readonly y_px: number;
  readonly px_per_m: number;
}

export function drawGrid(context: CanvasRenderingContext2D, picture: CanvasImageSource, { info }: OccupancyGrid, ground: Ground): void {
  const { resolution, width, height, origin } = info;
  const { x_px, y_px, px_per_m } = ground;
  context.imageSmoothingEnabled = false;
  const left = x_px + origin.position.x * px_per_m;
  const top = y_px - (origin.position.y + height * resolution) * px_per_m;
  context.drawImage(picture, left, top, width * resolution * px_per_m, height * resolution * px_per_m);
}

/** Older pieces are fainter. */
const PIECES = [0.3, 0.5, 0.7, 0.9];

export function drawTrail(context: CanvasRenderingContext2D, { trail, identity }: Robot, ground: Ground): void {
  context.strokeStyle = identity.colour;
  context.lineWidth = 2;
  context.lineJoin = "round";
  const length = Math.ceil(trail.length / PIECES.length);
  PIECES.forEach((opacity, i) => {
    context.globalAlpha = opacity;
    strokePiece(context, trail, i * length, Math.min((i + 1) * length, trail.length - 1), ground);
  });
  context.globalAlpha = 1;
}

/** A gap where the robot was not heard stays a gap. */
function strokePiece(context: CanvasRenderingContext2D, trail: readonly TrailPoint[], from: number, to: number, { x_px, y_px, px_per_m }: Ground): void {
  context.beginPath();
  for (let at = from; at <= to && at < trail.length; at += 1) {
    const point = trail[at]!;
    const [x, y] = [x_px + point.x_m * px_per_m, y_px - point.y_m * px_per_m];
    if (at === from || unknownSince(trail[at - 1]!, point)) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
  context.stroke();
}
