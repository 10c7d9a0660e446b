// SPDX-License-Identifier: BSD-3-Clause
// What a robot's blob detector would find in a picture, pixel for pixel: robot/vision/blobs.

export interface Threshold {
  level: number;
  /** Dark: pixels below the level stand out; else those of at least it. */
  dark: boolean;
}

/** Connected pixels; bounds are inclusive, rows count from the top. */
export interface Blob {
  area_px: number;
  left_px: number;
  top_px: number;
  right_px: number;
  bottom_px: number;
}

/** One byte a pixel: 1 where it stands out. `pixels`: one byte each. */
export function maskOf(pixels: Uint8Array, { level, dark }: Threshold): Uint8Array {
  return pixels.map((pixel) => Number(pixel < level === dark));
}

/** The blobs of a mask, 8 neighbours touching, of at least `minArea_px`; the largest first. */
export function blobsOf(mask: Uint8Array, width_px: number, minArea_px: number): Blob[] {
  const seen = new Uint8Array(mask.length);
  const blobs: Blob[] = [];
  for (let start = 0; start < mask.length; ++start) {
    if (!mask[start] || seen[start]) continue;
    const blob = flood(mask, seen, start, width_px);
    if (blob.area_px >= minArea_px) blobs.push(blob);
  }
  return blobs.sort((a, b) => b.area_px - a.area_px);
}

function flood(mask: Uint8Array, seen: Uint8Array, start: number, width_px: number): Blob {
  const height_px = mask.length / width_px;
  const blob: Blob = { area_px: 0, left_px: width_px, top_px: height_px, right_px: 0, bottom_px: 0 };
  const waiting = [start];
  seen[start] = 1;
  for (let at = waiting.pop(); at !== undefined; at = waiting.pop()) {
    const x = at % width_px;
    const y = (at - x) / width_px;
    absorb(blob, x, y);
    for (let row = Math.max(y - 1, 0); row <= Math.min(y + 1, height_px - 1); ++row)
      for (let column = Math.max(x - 1, 0); column <= Math.min(x + 1, width_px - 1); ++column) {
        const next = row * width_px + column;
        if (!mask[next] || seen[next]) continue;
        seen[next] = 1;
        waiting.push(next);
      }
  }
  return blob;
}

function absorb(blob: Blob, x: number, y: number): void {
  blob.area_px += 1;
  blob.left_px = Math.min(blob.left_px, x);
  blob.right_px = Math.max(blob.right_px, x);
  blob.top_px = Math.min(blob.top_px, y);
  blob.bottom_px = Math.max(blob.bottom_px, y);
}
