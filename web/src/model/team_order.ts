// SPDX-License-Identifier: BSD-3-Clause

/** The robots in trouble first, and by name among themselves: "robot2" before "robot10". It changes only as the trouble does. */
export function byTrouble<R extends { readonly name: string }>(robots: readonly R[], troubled: ReadonlySet<string>): R[] {
  const last = ({ name }: R) => Number(!troubled.has(name));
  return [...robots].sort((a, b) => last(a) - last(b) || a.name.localeCompare(b.name, "en", { numeric: true }));
}
