// SPDX-License-Identifier: BSD-3-Clause
import type { Covariance } from "../feed/parts";

export interface Ellipse {
  /** Half axes, two standard deviations long, in metres. */
  readonly major_m: number;
  readonly minor_m: number;
  /** Of the major axis, counter-clockwise from x. */
  readonly angle_rad: number;
}

/** Where the object is with about 86 %: the covariance's eigenvectors, two standard deviations long. */
export function ellipseOf({ variance_xx: xx, variance_xy: xy, variance_yy: yy }: Covariance): Ellipse {
  const mean = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  return {
    major_m: 2 * Math.sqrt(Math.max(mean + spread, 0)),
    minor_m: 2 * Math.sqrt(Math.max(mean - spread, 0)),
    angle_rad: 0.5 * Math.atan2(2 * xy, xx - yy),
  };
}
