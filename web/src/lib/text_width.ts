// SPDX-License-Identifier: BSD-3-Clause
// How wide a text is, without asking the page for its layout: that would force it to lay itself out there and then.

const KEPT = 500;
const widths_px = new Map<string, number>();
let context: CanvasRenderingContext2D | undefined;

/** The font that an element's text is in, as a canvas takes it. */
export function fontOf(element: Element): string {
  const { fontStyle, fontWeight, fontSize, fontFamily } = getComputedStyle(element);
  return `${fontStyle} ${fontWeight} ${fontSize} ${fontFamily}`; // `font` itself is empty where figures are tabular
}

export function textWidth_px(text: string, font: string): number {
  const key = `${font} ${text}`;
  let width_px = widths_px.get(key);
  if (width_px === undefined) {
    context ??= document.createElement("canvas").getContext("2d")!;
    context.font = font;
    width_px = context.measureText(text).width;
    if (widths_px.size >= KEPT) widths_px.clear();
    widths_px.set(key, width_px);
  }
  return width_px;
}
