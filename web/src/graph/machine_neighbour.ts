// SPDX-License-Identifier: BSD-3-Clause
import type { LaidArrow, LaidState } from "./machine_layout";

const TOWARDS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The state that an arrow key leads to: the nearest one on that side; undefined where there is none. */
export function neighbour(states: readonly LaidState[], from: string, key: string): string | undefined {
  const towards = TOWARDS[key];
  const here = states.find(({ name }) => name === from);
  if (!towards || !here) return undefined;
  const [right, down] = towards;
  const middle = ({ x, y, width, height }: LaidState) => [x + width / 2, y + height / 2] as const;
  const [x, y] = middle(here);
  const ahead = states.flatMap((state) => {
    const [dx, dy] = [middle(state)[0] - x, middle(state)[1] - y];
    const [along, aside] = [dx * right + dy * down, Math.abs(dx * down) + Math.abs(dy * right)];
    return along > 1 ? [{ name: state.name, far: along + 2 * aside }] : [];
  });
  return ahead.sort((a, b) => a.far - b.far)[0]?.name;
}

/** The arrow after or before `arrow` of those that leave a state, round and round; without `arrow` the first or the last. */
export function wayOut(arrows: readonly LaidArrow[], from: string, arrow: string | undefined, key: string): LaidArrow | undefined {
  const by = key === "PageDown" ? 1 : key === "PageUp" ? -1 : 0;
  const ways = arrows.filter((each) => each.from === from);
  if (by === 0 || ways.length === 0) return undefined;
  const at = ways.findIndex(({ to }) => `${from} → ${to}` === arrow);
  const next = at < 0 && by < 0 ? ways.length - 1 : at + by;
  return ways[(next + ways.length) % ways.length];
}
