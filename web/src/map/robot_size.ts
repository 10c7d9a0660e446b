// SPDX-License-Identifier: BSD-3-Clause

export const ROBOT_RADIUS_M = 0.2;
/** Smaller ones could not be told apart by their letters. */
const SMALLEST_PX = 11;

/** How far a robot reaches from its middle on a map of this scale. */
export const robotReach_px = (px_per_m: number): number => Math.max(ROBOT_RADIUS_M * px_per_m, SMALLEST_PX);
