// SPDX-License-Identifier: BSD-3-Clause

/** Where an outline is drawn: turned clockwise as seen (y down), then enlarged, then moved, in pixels. */
export interface Placement {
  readonly angle_rad?: number;
  readonly scale?: number;
  readonly x?: number;
  readonly y?: number;
}

/** Its numbers come in pairs, but for an arc, whose radii, turn and two flags stand before them. */
const NUMBERS_BEFORE_PLACE: Record<string, number> = { A: 5 };

/**
 * An SVG path of M, L, Z and arcs of circles, drawn elsewhere. It takes the place of a `transform`, for each of which
 * the browser keeps a layer of paint.
 */
export function turnedPath(path: string, { angle_rad = 0, scale = 1, x = 0, y = 0 }: Placement): string {
  const [cos, sin] = [Math.cos(angle_rad) * scale, Math.sin(angle_rad) * scale];
  return path.replace(/([MLA])([^MLAZ]*)/g, (_, command: string, told: string) => {
    const numbers = told.trim().split(/[\s,]+/).map(Number);
    const [rx, ry, ...flags] = numbers.splice(0, NUMBERS_BEFORE_PLACE[command] ?? 0);
    const before = rx === undefined ? "" : `${rx * scale},${ry! * scale} ${flags.join(" ")} `;
    const [along, down] = numbers as [number, number];
    return `${command}${before}${x + along * cos - down * sin},${y + along * sin + down * cos} `;
  });
}
