// SPDX-License-Identifier: BSD-3-Clause
// The boxes that lines of text on the map take up, in pixels, y down.

export interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

export const EVERYWHERE: Box = { left: -Infinity, right: Infinity, top: -Infinity, bottom: Infinity };

/** Above and below the line that letters stand on. */
export const ASCENT_PX = 9;
export const DESCENT_PX = 3;

export const overlap = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
export const isWithin = (a: Box, b: Box) => a.left >= b.left && a.right <= b.right && a.top >= b.top && a.bottom <= b.bottom;

/** The box seen from (`x`, `y`). */
export const seenFrom = ({ left, right, top, bottom }: Box, x: number, y: number): Box => ({ left: left - x, right: right - x, top: top - y, bottom: bottom - y });

/** The box of a line that begins at (`left`, `line`). */
export const textBox = (left: number, line: number, width_px: number): Box => ({ left, right: left + width_px, top: line - ASCENT_PX, bottom: line + DESCENT_PX });
