// SPDX-License-Identifier: BSD-3-Clause
// The items of the map that can be chosen: every robot whose pose is known, and every object. An object is a
// landmark of the team's map, as the monitor publishes it.

import type { Side } from "../layout/tree";
import type { Team } from "../model/model";

export interface MapItem {
  readonly key: string;
  readonly x_m: number;
  readonly y_m: number;
}

export const keyOf = {
  robot: (name: string) => `robot ${name}`,
  object: (id: number) => `object ${id}`,
};

export function itemsOn(team: Team): MapItem[] {
  const robots = [...team.robots.values()].flatMap(({ name, pose }) => (pose ? [{ key: keyOf.robot(name), x_m: pose.x_m, y_m: pose.y_m }] : []));
  const objects = (team.objects?.value ?? []).map(({ id, x_m, y_m }) => ({ key: keyOf.object(id), x_m, y_m }));
  return [...robots, ...objects];
}

/** Unit vectors on the map, y up. */
const TOWARDS: Record<Side, readonly [x: number, y: number]> = { left: [-1, 0], right: [1, 0], up: [0, 1], down: [0, -1] };

/** Returns the nearest item on that side. An item that lies off the direction counts as farther. */
export function nextItem(items: readonly MapItem[], from: MapItem, side: Side): MapItem | undefined {
  const [x, y] = TOWARDS[side];
  let [next, least] = [undefined as MapItem | undefined, Number.POSITIVE_INFINITY];
  for (const item of items) {
    const [dx, dy] = [item.x_m - from.x_m, item.y_m - from.y_m];
    const [ahead, aside] = [dx * x + dy * y, Math.abs(dx * y - dy * x)];
    const far = ahead + 2 * aside;
    if (item.key === from.key || ahead <= 0 || far >= least) continue;
    [next, least] = [item, far];
  }
  return next;
}

/** The item that stands so many after another in the list, round and round: it leads to those that no direction does. */
export function itemAfter(items: readonly MapItem[], from: MapItem, by: number): MapItem | undefined {
  return items[(items.indexOf(from) + by + items.length) % items.length];
}
