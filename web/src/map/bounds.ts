// SPDX-License-Identifier: BSD-3-Clause
import type { OccupancyGrid } from "../feed/messages";
import type { Team } from "../model/model";
import { ROBOT_RADIUS_M } from "./robot_size";

export interface Bounds {
  readonly left_m: number;
  readonly bottom_m: number;
  readonly width_m: number;
  readonly height_m: number;
}

const MARGIN_M = 0.5;

const known = new WeakMap<OccupancyGrid, Bounds | undefined>();

/** As `knownCells`, reckoned once a grid: it is large, and comes seldom. */
export function knownBounds(grid: OccupancyGrid): Bounds | undefined {
  if (!known.has(grid)) known.set(grid, knownCells(grid));
  return known.get(grid);
}

/** The cells that are known, less the unknown rim around them; undefined where none is. */
function knownCells({ info, data }: OccupancyGrid): Bounds | undefined {
  let [left, right, bottom, top] = [info.width, -1, info.height, -1];
  for (let row = 0; row < info.height; row += 1) {
    for (let column = 0; column < info.width; column += 1) {
      if (data[row * info.width + column]! < 0) continue;
      left = Math.min(left, column);
      right = Math.max(right, column);
      bottom = Math.min(bottom, row);
      top = Math.max(top, row);
    }
  }
  if (right < 0) return undefined;
  const { position } = info.origin;
  return {
    left_m: position.x + left * info.resolution,
    bottom_m: position.y + bottom * info.resolution,
    width_m: (right - left + 1) * info.resolution,
    height_m: (top - bottom + 1) * info.resolution,
  };
}

interface Place {
  readonly x_m: number;
  readonly y_m: number;
}

function corners({ left_m, bottom_m, width_m, height_m }: Bounds): Place[] {
  return [
    { x_m: left_m, y_m: bottom_m },
    { x_m: left_m + width_m, y_m: bottom_m + height_m },
  ];
}

const around = ({ x_m, y_m }: Place): Place[] => [-ROBOT_RADIUS_M, ROBOT_RADIUS_M].map((off_m) => ({ x_m: x_m + off_m, y_m: y_m + off_m }));

/** What the map must show to show everything: the known floor, every object and every robot. */
export function bounds(team: Team): Bounds | undefined {
  const floor = team.grid && knownBounds(team.grid);
  const poses = [...team.robots.values()].flatMap(({ pose }) => (pose ? around(pose) : []));
  const points = [...(floor ? corners(floor) : []), ...(team.objects?.value ?? []), ...poses];
  if (points.length === 0) return undefined;
  const xs = points.map((point) => point.x_m);
  const ys = points.map((point) => point.y_m);
  const margin_m = floor ? MARGIN_M / 4 : MARGIN_M * 2;
  const left_m = Math.min(...xs) - margin_m;
  const bottom_m = Math.min(...ys) - margin_m;
  return {
    left_m,
    bottom_m,
    width_m: Math.max(...xs) + margin_m - left_m,
    height_m: Math.max(...ys) + margin_m - bottom_m,
  };
}
