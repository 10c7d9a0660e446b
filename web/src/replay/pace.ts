// SPDX-License-Identifier: BSD-3-Clause
// How a recording is gone through.

/** Recorded seconds a second. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100] as const;
/** Between two looks of a robot at how it stands. */
export const STEP_S = 0.1;
/** What Page up and Page down go. */
export const PAGE_S = 10;
