// SPDX-License-Identifier: BSD-3-Clause
/** Where each panel stands until somebody arranges them, as layout/text.ts writes it. */
export const STANDARD =
  "r(73-c(53-r(33-c(69-team.31-program).67-map).18-timeline.29-r(57-variables.43-vision)).27-c(71-machine.29-why))";
