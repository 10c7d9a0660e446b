// SPDX-License-Identifier: BSD-3-Clause
// Where the floor's ranges lie in a camera's picture: robot/vision/camera_model, for a 4:3 sensor.

import type { Camera } from "./camera";

export interface ScaleLine {
  readonly row_px: number;
  /** Along the floor, straight ahead of the camera; undefined: the horizon. */
  readonly depth_m: number | undefined;
}

/** From the horizon down. */
const DEPTHS_M = [4, 2, 1, 0.5];
/** Closer lines than this would not be told apart. */
const LEAST_GAP_PX = 9;

/** From the horizon down, as far as the picture reaches. */
export function scaleLines({ height_m }: Camera, view_angle_rad: number, width_px: number, height_px: number): ScaleLine[] {
  const fx_px = width_px / 2 / Math.tan(view_angle_rad / 2);
  const fy_px = (fx_px * height_px) / ((width_px * 3) / 4);
  const horizon = { row_px: height_px / 2, depth_m: undefined };
  const ranges = DEPTHS_M.map((depth_m) => ({ row_px: height_px / 2 + (height_m * fy_px) / depth_m, depth_m }))
    .filter(({ row_px }) => row_px < height_px - 1);
  return ranges.reduce<ScaleLine[]>((lines, line) => (line.row_px - lines.at(-1)!.row_px < LEAST_GAP_PX ? lines : [...lines, line]), [horizon]);
}
