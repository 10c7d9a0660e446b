// SPDX-License-Identifier: BSD-3-Clause
/** How often each part of a machine happened. */
export interface MachineCounts {
  /** By the state's name; not never and 0 times: the robot was in it, and nobody saw it enter. */
  readonly states: ReadonlyMap<string, { readonly never: boolean; readonly times: number }>;
  /** By "from → to". */
  readonly arrows: ReadonlyMap<string, number>;
}
