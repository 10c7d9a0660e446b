// SPDX-License-Identifier: BSD-3-Clause
import type { OccupancyGrid } from "../feed/messages";

type Colour = readonly [red: number, green: number, blue: number];

const LIGHT = { free: [255, 255, 255] as Colour, occupied: [70, 74, 80] as Colour };
const DARK = { free: [38, 42, 48] as Colour, occupied: [168, 174, 182] as Colour };

/** The grid as a picture, north up, a pixel a cell: free to occupied between two greys, unknown transparent. */
export function gridPicture({ info, data }: OccupancyGrid, dark: boolean): HTMLCanvasElement | undefined {
  const canvas = document.createElement("canvas");
  canvas.width = info.width;
  canvas.height = info.height;
  const context = canvas.getContext("2d");
  if (!context || info.width === 0 || info.height === 0) return undefined;
  const image = context.createImageData(info.width, info.height);
  const pixels = new Uint32Array(image.data.buffer);
  const greys = greysOf(dark ? DARK : LIGHT);
  for (let row = 0; row < info.height; row += 1)
    for (let column = 0; column < info.width; column += 1) {
      const value = data[(info.height - 1 - row) * info.width + column]!;
      if (value >= 0) pixels[row * info.width + column] = greys[Math.min(value, 100)]!;
    }
  context.putImageData(image, 0, 0);
  return canvas;
}

/** For 0 to 100: bytes red, green, blue, alpha, the lowest first. */
function greysOf({ free, occupied }: typeof LIGHT): Uint32Array {
  return Uint32Array.from({ length: 101 }, (_, value) => {
    const [red, green, blue] = free.map((from, part) => Math.round(from + ((occupied[part]! - from) * value) / 100));
    return ((255 << 24) | (blue! << 16) | (green! << 8) | red!) >>> 0;
  });
}
