// SPDX-License-Identifier: BSD-3-Clause
// Values that stay the very same ones while they say the same, so that what depends on them is not reckoned or drawn anew.

/** Whether two plain values have the same fields. */
export function isAlike<T extends object>(a: T, b: T): boolean {
  const names = Object.keys(a) as (keyof T)[];
  return names.length === Object.keys(b).length && names.every((name) => Object.is(a[name], b[name]));
}

export const haveSame = <T>(a: ReadonlySet<T>, b: ReadonlySet<T>): boolean => a.size === b.size && [...a].every((each) => b.has(each));

/** Returns a function that gives the set of its last call again where the next one has the same members. */
export function steadySet<T>(): (next: ReadonlySet<T>) => ReadonlySet<T> {
  let kept: ReadonlySet<T> = new Set();
  return (next) => (haveSame(next, kept) ? kept : (kept = next));
}

/** Returns a function that gives each item of its last call again where the next one has the same under its key. */
export function steadyItems<T extends object>(keyOf: (item: T) => string): (next: readonly T[]) => readonly T[] {
  let kept: ReadonlyMap<string, T> = new Map();
  return (next) => {
    const items = next.map((item) => {
      const before = kept.get(keyOf(item));
      return before && isAlike(before, item) ? before : item;
    });
    kept = new Map(items.map((item) => [keyOf(item), item]));
    return items;
  };
}

/** Returns a function that gives the list of its last call again where the next one has the same items. */
export function steadyList<T>(isSame: (a: T, b: T) => boolean = Object.is): (next: readonly T[]) => readonly T[] {
  let kept: readonly T[] = [];
  return (next) => {
    const isKept = next.length === kept.length && next.every((item, i) => isSame(item, kept[i]!));
    return isKept ? kept : (kept = next);
  };
}
