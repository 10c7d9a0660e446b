// SPDX-License-Identifier: BSD-3-Clause
import type { Ellipse } from "../model/ellipse";

/**
 * An ellipse around (x, y) as an SVG path in pixels, y down. It is turned by its own arcs: a `transform` would
 * make the browser keep a layer of paint for each.
 */
export function ellipsePath({ major_m, minor_m, angle_rad }: Ellipse, px_per_m: number, x = 0, y = 0): string {
  const [major, minor] = [major_m * px_per_m, minor_m * px_per_m];
  const [dx, dy] = [major * Math.cos(angle_rad), -major * Math.sin(angle_rad)];
  const radii = `A${major},${minor} ${(-angle_rad * 180) / Math.PI} 1 0`;
  return `M${x + dx},${y + dy} ${radii} ${x - dx},${y - dy} ${radii} ${x + dx},${y + dy} Z`;
}
