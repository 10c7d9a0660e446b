// SPDX-License-Identifier: BSD-3-Clause
// Values that stay the very same ones while they say the same, so that what depends on them is not reckoned or drawn anew.

/** Whether two plain values have the same fields. */
export function isAlike<T extends object>(a: T, b: T): boolean {
  const names = Object.keys(a) as (keyof T)[];
  return names.length === Object.keys(b).length && names.every((name) => Object.is(a[name], b[name]));
}

/** Returns a function that gives the list of its last call again where the next one has the same items. */
export function steadyList<T>(isSame: (a: T, b: T) => boolean = Object.is): (next: readonly T[]) => readonly T[] {
  let kept: readonly T[] = [];
  return (next) => {
    const isKept = next.length === kept.length && next.every((item, i) => isSame(item, kept[i]!));
    return isKept ? kept : (kept = next);
  };
}
