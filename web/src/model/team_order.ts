// SPDX-License-Identifier: BSD-3-Clause

/** Made once: to compare by a language's name makes another each time. */
const { compare } = new Intl.Collator("en", { numeric: true });

/** The robots in trouble first, and by name among themselves: "robot2" before "robot10". It changes only as the trouble does. */
export function byTrouble<R extends { readonly name: string }>(robots: readonly R[], troubled: ReadonlySet<string>): R[] {
  const last = ({ name }: R) => Number(!troubled.has(name));
  return [...robots].sort((a, b) => last(a) - last(b) || compare(a.name, b.name));
}
