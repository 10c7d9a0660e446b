// SPDX-License-Identifier: BSD-3-Clause
// The floor and the trails on it, drawn on a canvas: there may be tens of thousands of points.

import type { OccupancyGrid } from "../feed/messages";
import type { Robot, TrailPoint } from "../model/model";
import { unknownSince } from "../model/trail";
import { type Point, straightened } from "./straightened";

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

/** Lines that are so near to where it went look the same. */
const OFF_PX = 0.4;

/** A gap where the robot was not heard stays a gap. */
function strokePiece(context: CanvasRenderingContext2D, trail: readonly TrailPoint[], from: number, to: number, ground: Ground): void {
  context.beginPath();
  for (const way of waysOf(trail.slice(from, to + 1), ground))
    straightened(way, OFF_PX).forEach(({ x, y }, i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  context.stroke();
}

/** The parts of a trail between its gaps, on the canvas. */
function waysOf(trail: readonly TrailPoint[], { x_px, y_px, px_per_m }: Ground): Point[][] {
  const ways: Point[][] = [];
  trail.forEach((point, i) => {
    if (i === 0 || unknownSince(trail[i - 1]!, point)) ways.push([]);
    ways.at(-1)!.push({ x: x_px + point.x_m * px_per_m, y: y_px - point.y_m * px_per_m });
  });
  return ways;
}
