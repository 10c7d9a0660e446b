// SPDX-License-Identifier: BSD-3-Clause

/** Made once: to compare by a language's name makes another each time. */
const { compare } = new Intl.Collator("en", { numeric: true });

type Names = { has(name: string): boolean };

/** More robots than these stand in a grid, and only the chosen one has a row. */
export const ROOMY = 5;
const NOBODY: Names = new Set<string>();

/** The silent robots first, then the others in trouble, each of them in their order. It changes only as the trouble does. */
export function troubleFirst<R extends { readonly name: string }>(robots: readonly R[], troubled: Names, silent: Names = NOBODY): R[] {
  const rank = ({ name }: R) => (silent.has(name) ? 0 : troubled.has(name) ? 1 : 2);
  return [...robots].sort((a, b) => rank(a) - rank(b));
}

/** The same, and by name among themselves: "robot2" before "robot10". */
export function byTrouble<R extends { readonly name: string }>(robots: readonly R[], troubled: Names, silent: Names = NOBODY): R[] {
  return troubleFirst([...robots].sort((a, b) => compare(a.name, b.name)), troubled, silent);
}

/** As they stand in the team's panel. */
export function asListed<R extends { readonly name: string }>(robots: readonly R[], troubled: Names, silent: Names): R[] {
  return (robots.length > ROOMY ? byTrouble : troubleFirst)(robots, troubled, silent);
}
