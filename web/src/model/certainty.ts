// SPDX-License-Identifier: BSD-3-Clause
/** Certainty now, of what was `certainty` when it was sampled and loses `decay_per_s` since. 0..1. */
export function certaintyAt(certainty: number, decay_per_s: number, age_ms: number): number {
  const left = certainty - (Math.max(decay_per_s, 0) * Math.max(age_ms, 0)) / 1000;
  return Math.min(Math.max(left, 0), 1);
}

/** Seconds until nothing is left, or undefined where nothing decays. */
export function forgottenIn_s(certainty: number, decay_per_s: number): number | undefined {
  return decay_per_s > 0 && certainty > 0 ? certainty / decay_per_s : undefined;
}
